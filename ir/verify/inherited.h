// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <functional>
#include <vector>

namespace glider::ir {

/// Which variables and which expressions have a property.
struct GreatestFixpoint {
  std::vector<bool> variables;
  std::vector<bool> expressions;

  /// Whether all operands of an expression have it, from operand `first` on; except those of a
  /// Call.
  [[nodiscard]] bool haveOperands(const Expr& e, uint32_t first = 0) const;
};

/// A property of values, such as "never unknown", and how it propagates.
struct Inheritance {
  /// Whether an expression has the property; `judged` already has the result for all its operands,
  /// and the present one for variables.
  std::function<bool(size_t expression, const GreatestFixpoint& judged)> expression;
  /// Whether a variable begins with it; `initial`: whether it has an initial value with the
  /// property.
  std::function<bool(const Variable& variable, bool initial)> begins;
  /// Whether a `set` to a value without the property removes it.
  bool lost_by_set = true;
};

/// The greatest fixpoint: all variables have the property until something without it can reach
/// them.
GreatestFixpoint greatestFixpoint(const Mission& mission, const Inheritance& inheritance);

}  // namespace glider::ir
