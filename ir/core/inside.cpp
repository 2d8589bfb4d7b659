// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/inside.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::ir {
namespace {

constexpr double kLargest_m = 20000;
constexpr double kNearPole_deg = 80;
/// The shortest degree of latitude on WGS 84, rounded down.
constexpr double kDegree_m = 110574;
constexpr int kCorners = 24;
/// The way round the Earth bends by r tan(latitude) / 2 R: 0.9 % of a radius of 20 km at 80
/// degrees.
constexpr double kBend = 1.02;
constexpr double kHalfTurn_deg = 180;

}  // namespace

/// By the number of edges that a ray to the east crosses.
bool isInside(const Geofence& area, const Position& place) {
  const auto east = [&](double other) { return std::remainder(other - place.longitude, 360); };
  bool inside = false;
  for (size_t i = 0; i < area.corners.size(); ++i) {
    const Position& a = area.corners[i];
    const Position& b = area.corners[(i + 1) % area.corners.size()];
    const bool crosses = (a.latitude <= place.latitude) != (b.latitude <= place.latitude);
    const double share = (place.latitude - a.latitude) / (b.latitude - a.latitude);
    inside ^= crosses && east(a.longitude) + share * (east(b.longitude) - east(a.longitude)) > 0;
  }
  return inside;
}

std::optional<Geofence> polygonAround(const Geofence& disc) {
  const Position& centre = disc.corners.front();
  const double step_rad = 2 * std::numbers::pi / kCorners;
  const double high_deg = kBend / std::cos(step_rad / 2) * disc.radius_m / kDegree_m;
  const double outermost_deg = std::fabs(centre.latitude) + high_deg;
  if (disc.radius_m > kLargest_m || outermost_deg > kNearPole_deg) {
    return std::nullopt;
  }
  // A degree of longitude is shortest where the disc is farthest from the equator.
  const double wide_deg = high_deg / std::cos(outermost_deg * std::numbers::pi / kHalfTurn_deg);
  Geofence polygon{disc.keep_in, {}, 0};
  for (int i = 0; i < kCorners; ++i) {
    const double bearing = i * step_rad;
    polygon.corners.push_back(
        {centre.latitude + high_deg * std::cos(bearing),
         std::remainder(centre.longitude + wide_deg * std::sin(bearing), 2 * kHalfTurn_deg)});
  }
  return polygon;
}

std::optional<Geofence> assumedStart(const Mission& mission) {
  const auto start =
      std::ranges::find(mission.assumptions, AssumptionKind::StartInside, &Assumption::kind);
  return start == mission.assumptions.end() ? std::nullopt : std::optional(start->area);
}

}  // namespace glider::ir
