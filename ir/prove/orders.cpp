// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/orders.h"

#include "ir/core/walk.h"

#include <algorithm>

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

std::optional<Position> fixedTarget(const Mission& mission, const Statement& order) {
  if (order.command != Command::SteerTo) {
    return std::nullopt;
  }
  const Expr& north = mission[order.values.at(0)];
  const Expr& east = mission[order.values.at(1)];
  const bool fixed = north.op == Op::Constant && east.op == Op::Constant;
  return fixed ? std::optional(Position{north.number, east.number}) : std::nullopt;
}

std::vector<Position> pathTargets(const Mission& mission, const Statement& order) {
  if (order.command != Command::SteerTo) {
    return {};
  }
  const Expr& north = mission[order.values.at(0)];
  const Expr& east = mission[order.values.at(1)];
  if (north.op != Op::Element || east.op != Op::Element) {
    return {};
  }
  const std::vector<double>& latitudes = mission[north.table].values;
  const std::vector<double>& longitudes = mission[east.table].values;
  std::vector<Position> places;
  for (size_t i = 0; i < std::min(latitudes.size(), longitudes.size()); ++i) {
    places.push_back({latitudes[i], longitudes[i]});
  }
  return places;
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
