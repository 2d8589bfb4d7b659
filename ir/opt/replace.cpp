// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/replace.h"

#include "ir/opt/compact.h"
#include "ir/opt/references.h"

namespace glider::ir::opt {
namespace {

struct Replacement {
  const std::vector<ExprId>& by;

  void operator()(ExprId& id) const { id = by[id.index]; }
  void operator()(BlockId&) const {}
  void operator()(StateId&) const {}
};

}  // namespace

void replace(Mission& mission, const std::vector<ExprId>& by) {
  Replacement replacement{by};
  for (Expr& expr : mission.exprs) {
    for (ExprId& operand : expr.operands) {
      if (operand.valid()) {
        replacement(operand);
      }
    }
  }
  References references(replacement);
  references.ofBody(mission);
  for (Block& block : mission.blocks) {
    references.of(block);
  }
  for (Temporal& temporal : mission.temporals) {
    references.of(temporal);
  }
  for (Variable& variable : mission.variables) {
    references.of(variable);
  }
  compact(mission);
}

}  // namespace glider::ir::opt
