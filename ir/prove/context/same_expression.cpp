// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/same_expression.h"

namespace glider::ir::prove {

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
bool isSameExpression(const Mission& mission, ExprId a, ExprId b) {
  if (a == b) {
    return true;
  }
  const Expr& x = mission[a];
  const Expr& y = mission[b];
  bool same = x.op == y.op && x.number == y.number && x.sensor == y.sensor &&
              x.variable == y.variable && x.temporal == y.temporal && x.table == y.table &&
              x.use == y.use;
  for (uint32_t i = 0; same && i < operandCount(x); ++i) {
    same = isSameExpression(mission, x.operands.at(i), y.operands.at(i));
  }
  return same;
}

}  // namespace glider::ir::prove
