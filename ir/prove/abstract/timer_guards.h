// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/abstract/abstract_evaluator.h"

#include <functional>
#include <limits>
#include <vector>

namespace glider::ir::prove {

/// A case that leads away when enough time has passed since something: it is certainly true when
/// the mission time is more than `longest` after that, s. Infinite: there is none.
struct TimerCase {
  size_t number = 0;  ///< in its list
  double longest = std::numeric_limits<double>::infinity();
};

/// What guards say of the time since a variable: `missiontime - since > T`, or the same sum. The
/// variable is never unknown, and never after the mission time.
class TimerGuards {
 public:
  /// Whether an expression is certainly true.
  using Certain = std::function<bool(ExprId)>;

  /// `proof_context` and `values` outlive this. The mission has ended by `ends_by` (mission time,
  /// s; infinite if that is not known).
  TimerGuards(const ProofContext& proof_context, const Valuation& values, double ends_by);

  /// A guard is certainly true when the mission time is more than this after `since`, s; infinite
  /// if that is not known.
  [[nodiscard]] double trueAfter(ExprId guard, VariableId since, const Certain& certain) const;
  /// It may be true only when the mission time is at least this after `since`, s.
  [[nodiscard]] double onlyAfter(ExprId guard, VariableId since) const;
  /// Whether all that is assigned to the variable, something at least, is `missiontime`.
  [[nodiscard]] bool holdsTimesOnly(VariableId id) const { return times_[id.index]; }

 private:
  /// The bounds of T in a comparison `more` > `less` of that form.
  struct Apart {
    double least = 0;
    double most = 0;
  };
  [[nodiscard]] Apart apart(ExprId more, ExprId less, VariableId since) const;
  [[nodiscard]] Apart compared(const Expr& e, VariableId since) const;
  [[nodiscard]] bool isSince(ExprId id, VariableId since) const;
  [[nodiscard]] Apart boundsOf(ExprId id) const;

  const Mission& m_;
  double ends_by_;
  AbstractEvaluator evaluator_;
  std::vector<bool> times_;  ///< of each variable: holdsTimesOnly
};

/// Whether a block may set the variable; an invalid one does not.
bool sets(const Mission& mission, BlockId block, VariableId variable);

}  // namespace glider::ir::prove
