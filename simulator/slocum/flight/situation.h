// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/seat/sensor_array.h"

#include <cstdint>
#include <limits>

namespace glider::simulator {

class Geography;

/// m_depth_state.
enum class DepthState : uint8_t { Surface, Diving, Climbing, Hovering };

/// What behaviours know in one control cycle. NaN for what is not known.
struct Situation {
  double time_s = 0;    ///< of the mission
  double flight_s = 0;  ///< since the beginning of the simulated flight: the journal's time
  double depth_m = 0;
  double depth_rate_mps = 0;  ///< positive when sinking
  DepthState depth_state = DepthState::Surface;
  double altitude_m = 0;
  double voltage = 0;
  double latitude_ddmm = 0, longitude_ddmm = 0;
  double waypoint_distance_m = 0;  ///< to the waypoint in force in the last cycle
  /// To the primary waypoint, m_dist_to_primary_wpt.
  double primary_distance_m = std::numeric_limits<double>::quiet_NaN();
  /// Since the vehicle last had contact with an operator: a behaviour surface was at the surface
  /// and done with its fix. The mission's start counts as one.
  double silent_s = 0;
  double untickled_s = 0;   ///< since the watchdog was last tickled: by contact or a GPS fix
  double utc_s = 0;         ///< since 1970
  double mission_mode = 0;  ///< u_mission_mode, a set of bits
  double inflections = 0;   ///< since the vehicle was last at the surface
  bool science_wants_surface = false;
  bool at_surface = false;
  bool gps_fix = false;
  SensorArray* array = nullptr;
  const Geography* geography = nullptr;
};

/// Shallower than this the vehicle counts as at the surface.
constexpr double kSurfaceDepth = 0.5;  // m
/// Slower than a quarter of the nominal 0.19 m/s the vehicle counts as hovering.
constexpr double kHoverRate = 0.25 * 0.19;  // m/s

}  // namespace glider::simulator
