// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks {

/// `x_hook_guard`: why hookbeh climbs against any instruction of the SBC.
enum class HookGuard : uint8_t {
  None = 0,
  TooDeep = 1,
  NearBottom = 2,
  DepthUnknown = 3,    ///< no reading, or one outside the range of a depth sensor
  DepthJumps = 4,      ///< it moved faster than the vehicle can
  DepthFrozen = 5,     ///< its bits did not change while the vehicle was driven
  DepthsDisagree = 6,  ///< the vehicle's own and the CTD's
  NoDepthGained = 7,   ///< pump in, and the vehicle does not sink
  NoHeightGained = 8,  ///< pump out, and the vehicle does not rise
};

enum class HeadingMode : uint8_t { CentreFin, Heading, Waypoint };

/// The pitch and pump that a sub-behaviour commands in one cycle.
struct VerticalCommand {
  double pitch_rad = 0;  ///< nose up positive
  double pump_cc = 0;    ///< positive lifts
  const char* doing = "";
};

/// The heading commanded in one cycle.
struct LateralCommand {
  HeadingMode mode = HeadingMode::CentreFin;
  double heading_rad = 0;
  double latitude_ddmm = 0;
  double longitude_ddmm = 0;
};

/// What the vehicle knows about its own situation in one cycle; NaN for unknown.
struct Surroundings {
  double depth_m = 0;
  double depth_rate_mps = 0;  ///< positive when sinking
  double altitude_m = 0;
  double ctd_depth_m = 0;  ///< from the pressure of the CTD
  double latitude_ddmm = 0;
  double longitude_ddmm = 0;
};

}  // namespace glider::hooks
