// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/port.h"
#include "hooks/protocol/instruction.h"
#include "runtime/abi/port_mission.h"

#include <stdint.h>

namespace glider::runtime::extctl {

/// The command for the stock behaviours of the mission file: the arguments that they take from
/// u_mission_param_…, whether to come up, and the bits of u_mission_mode.
struct StockCommand {
  double heading_rad = 0;  ///< from magnetic north
  double waypoint_latitude_ddmm = 0, waypoint_longitude_ddmm = 0;
  double dive_depth_m = 0;
  double climb_depth_m = hooks::extctl::kFirstClimbDepth;
  double dive_pitch_rad = 0, climb_pitch_rad = 0;
  bool surface = true;
  uint32_t modes = kGliderPortModeSurface;
};

/// Where the vehicle believes to be, as it reports it, and has just been; NaN for unknown.
struct Whereabouts {
  double latitude_ddmm = __builtin_nan("");
  double longitude_ddmm = __builtin_nan("");
  double variation_rad = __builtin_nan("");  ///< magnetic minus true heading
  double deep_m = 0;                         ///< as DepthSeen
};

/// `stock` changed to do what `instruction` says; what it does not say stays. A target depth is
/// one end of a yo, hold_m high, so that the vehicle holds the depth that it has reached and the
/// yo's targets never contradict each other: but only where the vehicle has just been so deep that
/// it can turn below the other end. Until then the upper end stays as shallow as it was, since near
/// a bottom the vehicle turns at an altitude, and a yo without a climb to turn to dives on. Without
/// mission modes there is no way to start a waypoint behaviour: then the heading is the bearing to
/// the waypoint, or stays if that is unknown. Drift keeps the heading.
void follow(const hooks::Instruction& instruction, const GliderPortMission& port,
            const Whereabouts& at, StockCommand& stock);

/// The steepness of a leg that no instruction has set yet, rad: the vehicle's own usual one.
inline constexpr double kUsualPitch = 0.4538;

/// Whether to come up, as the vehicle reads sci_wants_surface: 0 no, 2 now.
inline constexpr double kSurfaceNow = 2;

}  // namespace glider::runtime::extctl
