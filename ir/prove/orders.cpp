// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/orders.h"

#include "ir/core/walk.h"

namespace glider::ir::prove {
std::vector<const Statement*> ordersOf(const Mission& mission, const Activity& activity) {
  std::vector<const Statement*> orders;
  const auto gather = [&](const Statement& statement) {
    if (statement.kind == StatementKind::Command) {
      orders.push_back(&statement);
    }
  };
  forEachStatement(mission, activity.entry, gather);
  for (const Case& c : activity.cases) {
    forEachStatement(mission, c.action, gather);
  }
  return orders;
}

}  // namespace glider::ir::prove
