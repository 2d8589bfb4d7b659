// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/inside.h"

#include <algorithm>
#include <cmath>

namespace glider::ir {

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

std::optional<Geofence> assumedStart(const Mission& mission) {
  const auto start =
      std::ranges::find(mission.assumptions, AssumptionKind::StartInside, &Assumption::kind);
  return start == mission.assumptions.end() ? std::nullopt : std::optional(start->area);
}

}  // namespace glider::ir
