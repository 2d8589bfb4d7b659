// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/geography/local_frame.h"
#include "simulator/geography/planar.h"

#include <cstdint>
#include <functional>

namespace glider::simulator {

/// A waypoint as the vehicle steers to it, ddmm.mmmm.
struct WaypointPosition {
  double latitude_ddmm = 0, longitude_ddmm = 0;
};

/// wpt_units of a waypoint.
enum class WaypointUnits : uint8_t { LocalMetres, Utm, LatLon };

/// Turns waypoints in any of the vehicle's units into positions. Local metres (LMC) are relative to
/// the start of the mission, with y to magnetic north.
class Geography {
 public:
  /// `variation`: magnetic minus true heading at the start, rad.
  Geography(GeoPosition start, double variation) : start_(start), variation_(variation) {}

  [[nodiscard]] WaypointPosition position(WaypointUnits units, double x, double y) const;
  /// From x and y of the vehicle's local axes, magnetic east and north, to true ones and back.
  [[nodiscard]] Planar fromLocal(double x, double y) const;
  [[nodiscard]] Planar toLocal(Planar towards) const;
  /// m between two positions.
  [[nodiscard]] static double distance(const WaypointPosition& a, const WaypointPosition& b);

 private:
  GeoPosition start_;
  double variation_;
};

}  // namespace glider::simulator
