// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "tests/random_missions/random.h"

namespace glider::random_missions {

/// Adds random expressions to a mission whose sensors stand.
class ExpressionMaker {
 public:
  ExpressionMaker(ir::Mission& mission, Random& random) : m_(mission), random_(random) {}

  /// An expression of numbers of this type, nested at most `depth` deep.
  ir::ExprId number(ir::Type type, uint32_t depth);
  /// An expression of truth, nested at most `depth` deep (comparisons and what they compare come on
  /// top).
  ir::ExprId guard(uint32_t depth);
  /// `clock >= seconds`.
  ir::ExprId since(ir::Op clock, double seconds);
  ir::ExprId both(ir::ExprId a, ir::ExprId b) { return add(ir::Op::And, {a, b}); }

 private:
  ir::ExprId add(ir::Op op, std::array<ir::ExprId, 3> operands, ir::SensorId sensor = {});
  ir::ExprId constant(ir::Type type);
  double plainValue(ir::Type type);
  ir::ExprId leaf(ir::Type type);
  ir::ExprId product(ir::Type type, uint32_t depth);
  ir::ExprId quotient(ir::Type type, uint32_t depth);
  ir::ExprId root(ir::Type type, uint32_t depth);
  ir::ExprId comparison();

  ir::Mission& m_;
  Random& random_;
};

}  // namespace glider::random_missions
