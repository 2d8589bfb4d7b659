// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/truth.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <variant>
#include <vector>

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

/// The order in which the operations of an expression are evaluated, for one that is evaluated
/// again and again.
class Evaluation {
 public:
  /// `mission` outlives this.
  Evaluation(const Mission& mission, ExprId id);
  /// The value now: evaluates each operation once, operands first, at any depth.
  Value operator()(const Leaves& leaves) const;
  /// The number of operations.
  [[nodiscard]] size_t size() const { return order_.size(); }

 private:
  const Mission* mission_;
  std::vector<uint32_t> order_;     ///< the numbers of the expressions
  std::vector<uint32_t> operands_;  ///< of each in turn: where its operands are in `order_`
};

/// The evaluations of a mission's expressions, for those of which it is not known which are asked
/// for again: an order is found when it is first needed, and kept.
class Evaluations {
 public:
  /// `mission` outlives this.
  explicit Evaluations(const Mission& mission) : mission_(&mission) {}
  const Evaluation& of(ExprId id);

 private:
  const Mission* mission_;
  std::unordered_map<uint32_t, Evaluation> made_;
};

/// The value of expression `id`: evaluates each operation in it once, operands first, at any depth.
Value evaluate(const Mission& mission, ExprId id, const Leaves& leaves);

}  // namespace glider::ir
