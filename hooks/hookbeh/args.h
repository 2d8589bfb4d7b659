// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

namespace glider::hooks {

/// d_use_bpump and c_use_bpump, with the vehicle's codes. Any other code counts as Absolute.
enum class PumpMode : uint8_t {
  Autoballast = 0,  ///< the vehicle trims by itself: hookbeh commands the hull's whole stroke
  Absolute = 2,     ///< d_bpump_value, c_bpump_value
};

/// The b_args, from the mission file.
struct HookbehArgs {
  double start_secs = 0;  ///< ready from this time of the vehicle's mission, s
  double greatest_depth_m =
      30;  ///< deeper targets are refused; below it hookbeh climbs regardless of the SBC
  double least_altitude_m = 5;  ///< closer to the bottom it climbs; negative: no altimeter is used
  double steepest_pitch_rad = 0.61;  ///< magnitude
  double shallowest_pitch_rad = 0.19;
  double greatest_fin_rad = 0.45;    ///< magnitude; a fin farther out is refused
  double greatest_pump_cc = 233;     ///< commanded by the SBC, to either side; more is refused
  double greatest_battery_in = 0.6;  ///< of the pitch battery, the same
  double silence_secs = 24;          ///< without a changed heartbeat for this long the SBC is lost
  PumpMode dive_pump_mode = PumpMode::Absolute;
  PumpMode climb_pump_mode = PumpMode::Absolute;
  double dive_pump_cc = -230;
  double climb_pump_cc = 230;
  double hold_secs =
      12;  ///< after a target is reached, the commands stay this long, then hookbeh hovers there
};

}  // namespace glider::hooks
