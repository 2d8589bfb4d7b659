// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/verify/intervals.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace glider::ir {

/// What is known at a place in a mission beyond the ranges of its leaves: the ranges of expressions
/// that conditions have compared. The key is the first expression with the same reading.
struct Knowledge {
  std::map<uint32_t, Interval> within;
  /// Expressions that are not unknown: a comparison of them was true or false.
  std::set<uint32_t> known;
  bool unreachable = false;  ///< the place is never reached
};

/// What holds in either case.
Knowledge common(const Knowledge& a, const Knowledge& b);

/// The assumed result of a condition: for NotTrue and NotFalse it may also be unknown.
enum class Asked : uint8_t { True, False, NotTrue, NotFalse };

/// Reasons about a mission's conditions with intervals.
class Narrowing {
 public:
  /// Both outlive this. `intervals`: of every expression.
  Narrowing(const Mission& mission, const std::vector<Interval>& intervals);

  /// Adds what follows from the assumed result of a condition.
  void assume(Knowledge& knowledge, ExprId condition, Asked asked, unsigned depth = 0);
  /// The range of an expression when it is known.
  Interval intervalOf(const Knowledge& knowledge, ExprId id);
  /// A variable gets a value that lies in `given`; `kept`: or keeps its present value.
  void set(Knowledge& knowledge, VariableId variable, Interval given, bool kept);
  /// Whether an expression is known at every moment: made of constants, parameters and clocks.
  [[nodiscard]] bool isAlwaysKnown(ExprId id) const;

 private:
  void assumeBoth(Knowledge& knowledge, const Expr& e, Asked asked, unsigned depth);
  void assumeEither(Knowledge& knowledge, const Expr& e, Asked asked, unsigned depth);
  void compare(Knowledge& knowledge, const Expr& e, Asked asked);
  [[nodiscard]] bool isKnown(const Knowledge& knowledge, ExprId id) const;
  void narrow(Knowledge& knowledge, ExprId side, Op op, const Interval& other, bool definite);
  [[nodiscard]] Interval allowed(ExprId side, Op op, const Interval& now,
                                 const Interval& other) const;

  const Mission& m_;
  const std::vector<Interval>& plain_;
  std::vector<bool> whole_;
  std::vector<uint32_t> first_;  ///< for every expression, the first that is the same
  std::vector<std::optional<uint32_t>> read_as_;  ///< the first that reads each variable
  SubtreeIntervals work_;
};

}  // namespace glider::ir
