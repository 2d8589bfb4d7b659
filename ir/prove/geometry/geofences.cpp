// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/geometry/geofences.h"

#include "ir/core/inside.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/geometry/area_map.h"
#include "ir/prove/geometry/steering.h"
#include "support/units/position_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::ir::prove {
namespace {

/// Three days: in a longer time the current takes the vehicle out of any area.
constexpr double kLongest = 3 * 86400.0;

/// For an area to stay out of, m: control is given no farther than this from some waypoint.
constexpr double kStartWithin = 50000;

/// How far the vehicle may get off its legs, m, in `time` seconds, of which the SBC is without
/// power for `dark` at most.
double offLegs(const ProofContext& proof_context, bool by_heading, double time, double dark) {
  const platforms::EnvironmentModel& world = proof_context.platform.world;
  const double set =
      std::max(proof_context.platform.envelope.drift_m_s, world.surface_drift_m_s) * time;
  const double astray = by_heading ? time : std::min(time, dark + world.command_delay_s);
  return world.steering_error_m + set + world.through_water_m_s * astray;
}

std::string reasonOf(const ProofContext& proof_context, const Geofence& fence,
                     const Steering& steering, const Clearance& found, double time, double dark,
                     double margin) {
  const char* bound = fence.keep_in ? "to stay in" : "to stay out of";
  if (!found.right_side) {
    return fmt::format("not all of its legs are on the right side of the edge of the area {}",
                       bound);
  }
  return fmt::format(
      "its legs come within {} of the edge of the area {}; in at most {} of flight, the vehicle "
      "may deviate from them by {}: by surface drift of {:g} m/s{}",
      support::lengthText(found.distance_m), bound, durationOf(time), support::lengthText(margin),
      proof_context.platform.world.surface_drift_m_s,
      steering.by_heading ? fmt::format(", and by flying without a waypoint ({})", steering.where)
      : dark > 0          ? std::string(", and while the SBC has no power (`resume within`)")
                          : "");
}

}  // namespace

GeofenceVerdict judgeGeofences(const std::vector<Geofence>& geofences,
                               const ProofContext& proof_context, double dark_s, Ending& ending) {
  const auto end = ending.by(kLongest);
  if (!end) {
    return {false, 0, 0,
            "a geofence is decided only of a mission that ends within three days, by a case with a "
            "clock"};
  }
  const Steering steering = steeringOf(proof_context);
  const double off_legs = offLegs(proof_context, steering.by_heading, *end, dark_s);
  GeofenceVerdict verdict{true, off_legs, 0, ""};
  std::vector<Position> places = steering.waypoints;
  if (const auto start = assumedStart(proof_context.mission)) {
    places.insert(places.end(), start->corners.begin(), start->corners.end());
    verdict.start_assumed = true;
  }
  if (places.empty()) {
    return {false, 0, 0,
            "it does not steer to a waypoint, so its track has no bound unless it assumes where it "
            "starts: `assume start inside(…)`"};
  }
  for (const Geofence& fence : geofences) {
    const AreaMap map(fence, places);
    const Clearance found = map.clearance(fence, places);
    // For an area to stay in, the vehicle begins among its corners.
    const double start_within = fence.keep_in || verdict.start_assumed ? 0 : kStartWithin;
    const double margin = off_legs + map.bend_m(start_within);
    if (!map.holds(margin + start_within)) {
      return {false, 0, 0,
              "its area and its waypoints are too far apart, or too near a pole, for a flat map"};
    }
    if (!found.right_side || found.distance_m < margin) {
      return {false, 0, 0, reasonOf(proof_context, fence, steering, found, *end, dark_s, margin)};
    }
    // The pilot measures with `distance`, at any place where control may be given.
    const double stretch = fence.isDisc() ? map.stretch(margin + start_within) : 1;
    verdict.margin_m = std::max(verdict.margin_m, margin * stretch);
    verdict.start_within_m = std::max(verdict.start_within_m, start_within);
  }
  return verdict;
}

}  // namespace glider::ir::prove
