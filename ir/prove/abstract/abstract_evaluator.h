// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace glider::ir::prove {

/// The truth values that an expression may have, any of the three.
struct Truths {
  bool is_true = true, is_false = true, is_unknown = true;
  auto operator<=>(const Truths&) const = default;
};

/// The values that a variable may have when it is known: numbers between two bounds, or truth
/// values.
struct PossibleValues {
  double lowest = 0, highest = 0;
  bool never = false;  ///< it is never a known number
  Truths truths;
  auto operator<=>(const PossibleValues&) const = default;
};

/// The possible values of every variable.
using Valuation = std::vector<PossibleValues>;

/// Every value that the variable may have.
PossibleValues anything(const Variable& variable);
/// The part of `holding` that lies in the variable's range.
PossibleValues withinRange(PossibleValues holding, const Variable& variable);
/// The union of both.
PossibleValues either(const PossibleValues& a, const PossibleValues& b);

/// The ranges of the three clocks, s.
struct ClockRanges {
  Interval mission_time, state_time, resume_time;
};

/// What the reading of one sensor may be at a moment.
struct AssumedReading {
  SensorId sensor;
  Interval reading;   ///< when it is known
  bool ever = false;  ///< the same holds for all its earlier readings
};

/// Temporals, by number: a `held` that is never true, a window that is never known.
using IdleTemporals = std::vector<bool>;

/// Evaluates expressions abstractly: the values that they may have at a moment, for any readings of
/// the sensors. It uses no solver and ignores how values depend on each other, so the result may
/// include values that cannot occur.
///
/// An expression is evaluated when it is first asked for, with all that it reads and nothing else:
/// a state of a large mission costs what its own guards cost.
class AbstractEvaluator {
 public:
  /// `proof_context`, `values` and `idle` outlive this, and `values` stays the same meanwhile.
  AbstractEvaluator(const ProofContext& proof_context, const Valuation& values,
                    const ClockRanges& clocks, std::optional<AssumedReading> sight = std::nullopt,
                    const IdleTemporals* idle = nullptr);

  [[nodiscard]] const Truths& truth(ExprId id) const { return at(id).truths; }
  /// For a number, its range when it is known; for a truth value, the values that it may have.
  [[nodiscard]] PossibleValues holding(ExprId id) const;
  [[nodiscard]] const Interval& number(ExprId id) const { return at(id).number; }
  /// Whether the expression may be unknown.
  [[nodiscard]] bool maybeUnknown(ExprId id) const;
  /// The number of expressions that were evaluated.
  [[nodiscard]] size_t work() const { return made_.size(); }

 private:
  struct Evaluated {
    Interval number;
    Truths truths;
  };

  [[nodiscard]] const Evaluated& at(ExprId id) const;
  [[nodiscard]] Evaluated make(uint32_t index) const;
  [[nodiscard]] std::optional<Interval> leaf(const Expr& e) const;
  [[nodiscard]] Truths judge(const Expr& e, uint32_t index) const;
  [[nodiscard]] Truths watched(const Temporal& temporal) const;
  [[nodiscard]] Interval window(TemporalId id) const;
  [[nodiscard]] bool isIdle(TemporalId id) const { return idle_ != nullptr && (*idle_)[id.index]; }
  [[nodiscard]] Truths logic(const Expr& e) const;
  [[nodiscard]] Truths compared(const Expr& e) const;
  [[nodiscard]] const Evaluated& operand(const Expr& e, size_t i) const;

  const ProofContext& proof_context_;
  const Valuation& values_;
  ClockRanges clocks_;
  std::optional<AssumedReading> sight_;
  const IdleTemporals* idle_;
  mutable std::unordered_map<uint32_t, Evaluated> made_;
  mutable std::vector<uint32_t> open_;  ///< what is to be evaluated; here to keep its memory
};

}  // namespace glider::ir::prove
