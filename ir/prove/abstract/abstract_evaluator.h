// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace glider::ir::prove {

/// The truth values that something may have, any of the three.
struct Truths {
  bool is_true = true, is_false = true, is_unknown = true;
  auto operator<=>(const Truths&) const = default;
};

/// What a variable may hold when it is known: a number between two, or a truth value.
struct Holding {
  double lowest = 0, highest = 0;
  bool never = false;  ///< it is never a known number
  Truths truths;
  auto operator<=>(const Holding&) const = default;
};

/// Of every variable.
using Valuation = std::vector<Holding>;

/// Anything that the variable may hold.
Holding anything(const Variable& variable);
/// What of `holding` lies in the variable's range.
Holding withinRange(Holding holding, const Variable& variable);
/// What either says.
Holding either(const Holding& a, const Holding& b);

/// Where the three clocks lie, s.
struct ClockRanges {
  Interval mission_time, state_time, resume_time;
};

/// What expressions may be worth at a moment, whatever the sensors say: no solver, nothing about
/// how values depend on each other, so sometimes more than they can.
class AbstractEvaluator {
 public:
  AbstractEvaluator(const ProofContext& proof_context, const Valuation& values,
                    const ClockRanges& clocks);

  [[nodiscard]] const Truths& truth(ExprId id) const { return truths_[id.index]; }
  /// Of a number, where it lies when it is known; of a truth value its truths.
  [[nodiscard]] Holding holding(ExprId id) const;
  [[nodiscard]] const Interval& number(ExprId id) const { return numbers_[id.index]; }
  /// Whether it may be unknown.
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
