// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/fences.h"

#include "ir/prove/area_map.h"
#include "ir/prove/steering.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::ir::prove {
namespace {

/// Three days: in more the current takes it beyond any area, and beyond the map of area_map.h.
constexpr double kLongest = 3 * 86400.0;

/// How far it may be set off its legs, m, in `time` seconds.
double setOff(const Ground& ground, bool by_heading, double time) {
  const double adrift = ground.platform.envelope.drift_m_s * time;
  const double anywhere = by_heading ? ground.platform.world.through_water_m_s * time : 0;
  return ground.platform.world.steering_error_m + adrift + anywhere;
}

std::string reasonOf(const Ground& ground, const Fence& fence, const Steering& steering,
                     const Clearance& found, double time, double margin) {
  const char* bound = fence.keep_in ? "to keep in" : "to keep out of";
  if (!found.right_side) {
    return fmt::format("not all of its legs are on the right side of the edge of the area {}",
                       bound);
  }
  return fmt::format(
      "its legs come within {:.0f} m of the edge of the area {}; in the {:.0f} s that it flies at "
      "most, a current of {:g} m/s{} may set it off by {:.0f} m",
      found.distance_m, bound, time, ground.platform.envelope.drift_m_s,
      steering.by_heading ? " and what it goes without a waypoint" : "", margin);
}

}  // namespace

FenceVerdict judgeFences(const std::vector<Fence>& fences, const Ground& ground, Ending& ending) {
  const auto end = ending.by(kLongest);
  if (!end) {
    return {false, 0, "no time up to three days is known by which the mission has ended"};
  }
  const Steering steering = steeringOf(ground);
  FenceVerdict verdict{true, setOff(ground, steering.by_heading, *end), ""};
  if (steering.waypoints.empty()) {
    return {false, 0, "it steers to no waypoint, so nothing says where it flies"};
  }
  for (const Fence& fence : fences) {
    const AreaMap map(fence.corners, steering.waypoints);
    const Clearance found = map.clearance(fence, steering.waypoints);
    const double margin = verdict.margin_m + map.bend_m();
    if (!found.right_side || found.distance_m < margin) {
      return {false, 0, reasonOf(ground, fence, steering, found, *end, margin)};
    }
    verdict.margin_m = std::max(verdict.margin_m, margin);
  }
  return verdict;
}

}  // namespace glider::ir::prove
