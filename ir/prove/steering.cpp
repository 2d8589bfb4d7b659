// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/steering.h"

#include "ir/prove/orders.h"

namespace glider::ir::prove {
namespace {

/// The corners of the box in which a place lies that is worked out; false if it may be anywhere.
bool addBox(const Interval& north, const Interval& east, std::vector<Position>& places) {
  if (north.empty || east.empty || north.lowest <= -90 || north.highest >= 90 ||
      east.highest - east.lowest >= 180) {
    return false;
  }
  for (const double latitude : {north.lowest, north.highest}) {
    for (const double longitude : {east.lowest, east.highest}) {
      places.push_back({latitude, longitude});
    }
  }
  return true;
}

/// Whether a path gives the order both coordinates from one row, so that they are one of its
/// places.
bool fromOneRow(const Mission& m, const Expr& north, const Expr& east) {
  return north.operands[0] == east.operands[0] &&
         m[north.table].values.size() == m[east.table].values.size();
}

/// False if it may be anywhere.
bool addTarget(const Ground& ground, const Statement& order, std::vector<Position>& places) {
  const ExprId north = order.values.at(0);
  const ExprId east = order.values.at(1);
  const std::vector<Position> path = pathTargets(ground.mission, order);
  if (path.empty()) {
    return addBox(ground.intervals[north.index], ground.intervals[east.index], places);
  }
  places.insert(places.end(), path.begin(), path.end());
  return fromOneRow(ground.mission, ground.mission[north], ground.mission[east]);
}

}  // namespace

Steering steeringOf(const Ground& ground) {
  Steering steering;
  for (const State& state : ground.mission.states) {
    const bool in_c = !ground.mission[state.route.behaviour].symbol.empty();
    steering.by_heading = steering.by_heading || in_c;
    for (const Statement* order : ordersOf(ground.mission, state.route)) {
      if (order->command != Command::SteerTo || !addTarget(ground, *order, steering.waypoints)) {
        steering.by_heading = steering.by_heading || !isVertical(order->command);
      }
    }
  }
  return steering;
}

}  // namespace glider::ir::prove
