// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/passes.h"
#include "ir/opt/replace.h"

#include <bit>
#include <map>
#include <tuple>

namespace glider::ir::opt {
namespace {

/// All that makes two expressions the same; numbers by their bits.
auto keyOf(const Expr& e) {
  return std::tuple(e.op, e.type.kind, e.type.dimension.exponents, e.operands,
                    std::bit_cast<uint64_t>(e.number), e.sensor, e.variable, e.temporal);
}

}  // namespace

/// An expression has the value of the moment at which it is evaluated, so one node may serve any
/// number of places.
void shareExpressions(Mission& mission) {
  std::map<decltype(keyOf(mission.exprs.front())), ExprId> first;
  std::vector<ExprId> by(mission.exprs.size());
  for (uint32_t i = 0; i < by.size(); ++i) {
    Expr& expr = mission.exprs[i];
    for (ExprId& operand : expr.operands) {
      operand = operand.valid() ? by[operand.index] : operand;
    }
    by[i] = first.emplace(keyOf(expr), ExprId{i}).first->second;
  }
  replace(mission, by);
}

}  // namespace glider::ir::opt
