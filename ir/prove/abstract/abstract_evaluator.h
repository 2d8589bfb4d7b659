// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace glider::ir::prove {

/// The truth values that an expression may have, any of the three.
struct Truths {
  bool is_true = true, is_false = true, is_unknown = true;
  auto operator<=>(const Truths&) const = default;
};

/// The values that a variable may have when it is known: numbers between two bounds, or truth
/// values.
struct Holding {
  double lowest = 0, highest = 0;
  bool never = false;  ///< it is never a known number
  Truths truths;
  auto operator<=>(const Holding&) const = default;
};

/// The possible values of every variable.
using Valuation = std::vector<Holding>;

/// Every value that the variable may have.
Holding anything(const Variable& variable);
/// The part of `holding` that lies in the variable's range.
Holding withinRange(Holding holding, const Variable& variable);
/// The union of both.
Holding either(const Holding& a, const Holding& b);

/// The ranges of the three clocks, s.
struct ClockRanges {
  Interval mission_time, state_time, resume_time;
};

/// Evaluates expressions abstractly: the values that they may have at a moment, for any readings of
/// the sensors. It uses no solver and ignores how values depend on each other, so the result may
/// include values that cannot occur.
class AbstractEvaluator {
 public:
  AbstractEvaluator(const ProofContext& proof_context, const Valuation& values,
                    const ClockRanges& clocks);

  [[nodiscard]] const Truths& truth(ExprId id) const { return truths_[id.index]; }
  /// For a number, its range when it is known; for a truth value, the values that it may have.
  [[nodiscard]] Holding holding(ExprId id) const;
  [[nodiscard]] const Interval& number(ExprId id) const { return numbers_[id.index]; }
  /// Whether the expression may be unknown.
  [[nodiscard]] bool maybeUnknown(ExprId id) const;

 private:
  [[nodiscard]] Truths judge(const Expr& e, uint32_t index) const;
  [[nodiscard]] Truths logic(const Expr& e) const;
  [[nodiscard]] Truths compared(const Expr& e) const;
  [[nodiscard]] const Truths& operand(const Expr& e, size_t i) const;

  const ProofContext& proof_context_;
  const Valuation& values_;
  std::vector<Interval> numbers_;
  std::vector<Truths> truths_;
};

}  // namespace glider::ir::prove
