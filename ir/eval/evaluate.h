// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/truth.h"

#include <functional>
#include <span>
#include <variant>

namespace glider::ir {

/// A number (NaN: unknown, always the same NaN) or a truth value.
using Value = std::variant<double, Truth>;

/// How a variable of type bool is stored: 0 false, 1 true, NaN unknown.
double asNumber(Value value);
/// A variable's value as an expression of `type` sees it.
Value asValue(double number, Type type);

/// The current values of Sensor, Age, Variable, Temporal and the clocks, and of a Call with its
/// arguments as numbers.
using Leaves = std::function<Value(const Expr&, std::span<const double> arguments)>;

/// The value of expression `id`: evaluates each operation in it once, operands first, at any depth.
Value evaluate(const Mission& mission, ExprId id, const Leaves& leaves);

}  // namespace glider::ir
