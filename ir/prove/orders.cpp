// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/orders.h"

namespace glider::ir::prove {
namespace {

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void gather(const Mission& mission, BlockId id, std::vector<const Statement*>& orders) {
  if (!id.valid()) {
    return;
  }
  for (const Statement& statement : mission[id].statements) {
    if (statement.kind == StatementKind::Command) {
      orders.push_back(&statement);
    } else if (statement.kind == StatementKind::If) {
      gather(mission, statement.then, orders);
      gather(mission, statement.otherwise, orders);
    }
  }
}

}  // namespace

std::vector<const Statement*> ordersOf(const Mission& mission, const Activity& activity) {
  std::vector<const Statement*> orders;
  gather(mission, activity.entry, orders);
  for (const Case& c : activity.cases) {
    gather(mission, c.action, orders);
  }
  return orders;
}

}  // namespace glider::ir::prove
