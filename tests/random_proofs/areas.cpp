// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/areas.h"

#include "ir/core/mission_writer.h"
#include "ir/eval/arithmetic.h"
#include "ir/prove/geometry/steering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::random_proofs {
namespace {

using ir::ExprId;
using ir::Op;

constexpr double kMetresPerDegree = 111000;  ///< a little less than on the ground

std::optional<ir::SensorId> find(const ir::Mission& mission, const char* vehicle_name) {
  for (uint32_t i = 0; i < mission.sensors.size(); ++i) {
    if (mission.sensors[i].vehicle_name == vehicle_name &&
        mission.sensors[i].encoding == ir::Encoding::DegreesMinutes) {
      return ir::SensorId{i};
    }
  }
  return std::nullopt;
}

/// To keep `metres` off the track: within a disc about its middle, or out of one to its north.
ir::Geofence discAbout(const Track& track, double metres, bool keep_in) {
  constexpr double kIsle = 20000;
  ir::Position centre{(track.south_west.latitude + track.north_east.latitude) / 2,
                      (track.south_west.longitude + track.north_east.longitude) / 2};
  if (!keep_in) {
    centre.latitude = track.north_east.latitude + (kIsle + metres) / kMetresPerDegree;
    return {false, {centre}, kIsle};
  }
  const ir::Position equatorward{
      std::fabs(track.south_west.latitude) < std::fabs(track.north_east.latitude)
          ? track.south_west.latitude
          : track.north_east.latitude,
      track.north_east.longitude};
  return {true, {centre}, metres + ir::onEarth(Op::Distance, centre, equatorward)};
}

}  // namespace

bool writeDisc(ir::Mission& mission, ir::Requirement& requirement, const Track& track,
               Conditions& conditions, random_missions::Random& random) {
  const auto lat = find(mission, "m_lat");
  const auto lon = find(mission, "m_lon");
  if (!lat || !lon) {
    return false;
  }
  constexpr double kMargins[] = {0.9, 1.1, 1.2, 1.5};
  const double metres = random.pick(kMargins) * track.off_legs_m;
  const bool keep_in = random.chance(0.7);
  const ir::Geofence disc = discAbout(track, metres, keep_in);
  const ir::Position& centre = disc.corners.front();
  if (std::fabs(centre.latitude) > 80) {
    return false;
  }
  ir::MissionWriter write(mission);
  const ExprId north = conditions.reading(*lat);
  const ExprId east = conditions.reading(*lon);
  const ExprId to_north = write.number(centre.latitude, mission[*lat].type);
  const ExprId to_east = write.number(centre.longitude, mission[*lon].type);
  const ir::Type length = ir::quantity(support::dimension::length);
  const ExprId distance = write.operation(Op::Distance, length, {north, east, to_north, to_east});
  requirement.condition = write.operation(keep_in ? Op::Less : Op::Greater, ir::boolean(),
                                          {distance, write.number(disc.radius_m, length)});
  requirement.geofences = {disc};
  return true;
}

std::optional<Track> trackOf(const ir::prove::ProofContext& context, ir::prove::Ending& ending) {
  constexpr double kFarthest = 2;  // degrees
  const ir::prove::Steering steering = ir::prove::steeringOf(context);
  const auto by = ending.bound().by;
  if (steering.waypoints.empty() || !by) {
    return std::nullopt;
  }
  Track track{steering.waypoints.front(), steering.waypoints.front()};
  for (const ir::Position& place : steering.waypoints) {
    track.south_west.latitude = std::min(track.south_west.latitude, place.latitude);
    track.south_west.longitude = std::min(track.south_west.longitude, place.longitude);
    track.north_east.latitude = std::max(track.north_east.latitude, place.latitude);
    track.north_east.longitude = std::max(track.north_east.longitude, place.longitude);
  }
  const platforms::EnvironmentModel& world = context.platform.world;
  const double drift = std::max(context.platform.envelope.drift_m_s, world.surface_drift_m_s);
  const double astray = steering.by_heading ? *by : std::min(*by, context.mission.resume_within_s);
  track.off_legs_m = world.steering_error_m + drift * *by + world.through_water_m_s * astray;
  const bool near = track.north_east.latitude - track.south_west.latitude < kFarthest &&
                    track.north_east.longitude - track.south_west.longitude < kFarthest &&
                    std::fabs(track.north_east.latitude) < 80;
  return near ? std::optional(track) : std::nullopt;
}

bool writeArea(ir::Mission& mission, ir::Requirement& requirement, const Track& track,
               Conditions& conditions, random_missions::Random& random) {
  const auto lat = find(mission, "m_lat");
  const auto lon = find(mission, "m_lon");
  if (!lat || !lon) {
    return false;
  }
  constexpr double kMargins[] = {0.9, 1.03, 1.1, 1.5};
  const double metres = random.pick(kMargins) * track.off_legs_m;
  const double north =
      std::max(std::fabs(track.north_east.latitude), std::fabs(track.south_west.latitude));
  const double high = metres / kMetresPerDegree;
  const double wide = high / std::cos(north * std::numbers::pi / 180);
  const bool keep_in = random.chance(0.7);
  double south = track.south_west.latitude - high;
  double top = track.north_east.latitude + high;
  const double west = track.south_west.longitude - wide;
  const double east = track.north_east.longitude + wide;
  if (!keep_in) {  // to the north of the track
    south = top;
    top += 0.5;
  }
  if (west < -180 || east > 180 || south < -90 || top > 90) {
    return false;
  }
  ir::MissionWriter write(mission);
  const auto is = [&](Op op, ir::SensorId sensor, double limit) {
    const ExprId reading = conditions.reading(sensor);
    return write.operation(op, ir::boolean(), {reading, write.number(limit, mission[sensor].type)});
  };
  const ExprId below = write.both(is(Op::GreaterEqual, *lat, south), is(Op::LessEqual, *lat, top));
  const ExprId beside = write.both(is(Op::GreaterEqual, *lon, west), is(Op::LessEqual, *lon, east));
  const ExprId inside = write.both(below, beside);
  requirement.condition = keep_in ? inside : write.negation(inside);
  requirement.geofences = {{keep_in, {{south, west}, {south, east}, {top, east}, {top, west}}}};
  return true;
}

}  // namespace glider::random_proofs
