// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/core/ops.h"

#include <unordered_set>
#include <vector>

namespace glider::ir {

/// Whether `is` holds for the expression at `root` or for one in it; each is checked once, even if
/// it occurs several times. `is` takes an Expr.
template <typename Predicate>
bool anyIn(const Mission& mission, ExprId root, Predicate is) {
  std::vector<ExprId> open{root};
  std::unordered_set<uint32_t> seen;
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!seen.insert(id.index).second) {
      continue;
    }
    const Expr& e = mission[id];
    if (is(e)) {
      return true;
    }
    open.insert(open.end(), e.operands.begin(), e.operands.begin() + operandCount(e));
  }
  return false;
}

/// Calls `visit` once for the expression at `root` and for each one in it.
template <typename Visit>
void forEachIn(const Mission& mission, ExprId root, Visit visit) {
  (void)anyIn(mission, root, [&](const Expr& e) {
    visit(e);
    return false;
  });
}

/// Calls `visit` for each statement of a block in the order of the text; an `if` comes before both
/// its branches. An invalid id is an empty block.
template <typename Visit>
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void forEachStatement(const Mission& mission, BlockId block, const Visit& visit) {
  if (!block.valid()) {
    return;
  }
  for (const Statement& statement : mission[block].statements) {
    visit(statement);
    if (statement.kind == StatementKind::If) {
      forEachStatement(mission, statement.then, visit);
      forEachStatement(mission, statement.otherwise, visit);
    }
  }
}

}  // namespace glider::ir
