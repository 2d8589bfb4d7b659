// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <compare>
#include <limits>
#include <vector>

namespace glider::ir::prove {

/// What is certain after any tick that leaves a state current, or that ends the mission in it.
struct StateBounds {
  double earliest = 0;  ///< mission time, s
  double latest = 0;
  double resume_time = 0;  ///< upper bounds of the clocks, s
  double state_time = 0;
  double depth = 0;  ///< upper bound of the true depth, m
  /// It commands the surface whenever it becomes current, and no other depth while it is. Only
  /// Insight::byState sets it; elsewhere it is false.
  bool climbs = false;
  auto operator<=>(const StateBounds&) const = default;
};

/// Within all of them.
inline StateBounds hullOf(const std::vector<StateBounds>& all) {
  StateBounds hull{std::numeric_limits<double>::max(), 0, 0, 0, 0, false};
  for (const StateBounds& one : all) {
    hull.earliest = std::min(hull.earliest, one.earliest);
    hull.latest = std::max(hull.latest, one.latest);
    hull.resume_time = std::max(hull.resume_time, one.resume_time);
    hull.state_time = std::max(hull.state_time, one.state_time);
    hull.depth = std::max(hull.depth, one.depth);
  }
  return hull;
}

}  // namespace glider::ir::prove
