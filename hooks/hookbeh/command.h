// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/doing.h"

#include <stdint.h>

namespace glider::hooks {

enum class HeadingMode : uint8_t { CentreFin, Heading, Waypoint, Fin };

enum class PitchMode : uint8_t { Servo, Battery };

/// The pitch and pump that a sub-behaviour commands in one cycle.
struct VerticalCommand {
  double pitch_rad = 0;  ///< nose up positive; of a battery position: what the guards assume
  double pump_cc = 0;    ///< positive lifts
  Doing doing = Doing::Nothing;
  PitchMode pitch_mode = PitchMode::Servo;
  double battery_in = 0;  ///< positive lowers the nose
};

/// The heading or fin commanded in one cycle.
struct LateralCommand {
  HeadingMode mode = HeadingMode::CentreFin;
  double heading_rad = 0;
  double latitude_ddmm = 0;
  double longitude_ddmm = 0;
  double fin_rad = 0;  ///< positive to turn to starboard
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
