// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/snippet.h"

#include "ir/core/mission_writer.h"

namespace glider::frontend {
namespace {

ir::ExprId append(const ir::Mission& mission, ir::ExprId id, Snippet& out) {
  ir::Expr expr = mission[id];
  for (ir::ExprId& operand : expr.operands) {
    if (operand.valid()) {
      operand = append(mission, operand, out);
    }
  }
  out.push_back(expr);
  return {static_cast<uint32_t>(out.size() - 1)};
}

}  // namespace

Snippet copy(const ir::Mission& mission, ir::ExprId root) {
  Snippet out;
  append(mission, root, out);
  return out;
}

ir::ExprId paste(const Snippet& snippet, ir::Mission& mission) {
  const auto start = static_cast<uint32_t>(mission.exprs.size());
  ir::MissionWriter write(mission);
  ir::ExprId root;
  for (ir::Expr expr : snippet) {
    for (ir::ExprId& operand : expr.operands) {
      operand.index += operand.valid() ? start : 0;
    }
    root = write.add(expr);
  }
  return root;
}

}  // namespace glider::frontend
