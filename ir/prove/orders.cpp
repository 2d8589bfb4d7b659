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

bool isVertical(Command command) {
  switch (command) {
    case Command::Descend:
    case Command::Ascend:
    case Command::Hover:
    case Command::Surface:
      return true;
    case Command::Steer:
    case Command::SteerTo:
    case Command::Drift:
      return false;
  }
  return false;
}

}  // namespace glider::ir::prove
