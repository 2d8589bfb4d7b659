// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/steering.h"

#include "ir/prove/orders.h"

#include <algorithm>

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

bool addTarget(const Ground& ground, const Statement& order, std::vector<Position>& places) {
  const Mission& m = ground.mission;
  const Expr& north = m[order.values.at(0)];
  const Expr& east = m[order.values.at(1)];
  if (north.op != Op::Element || east.op != Op::Element) {
    return addBox(ground.intervals[order.values[0].index], ground.intervals[order.values[1].index],
                  places);
  }
  const auto& latitudes = m[north.table].values;
  const auto& longitudes = m[east.table].values;
  for (size_t i = 0; i < std::min(latitudes.size(), longitudes.size()); ++i) {
    places.push_back({latitudes[i], longitudes[i]});
  }
  return latitudes.size() == longitudes.size() && north.operands[0] == east.operands[0];
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
