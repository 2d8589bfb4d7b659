// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "vehicles/dock.h"
#include "vehicles/slocum/mission_files/extctl_file.h"
#include "vehicles/slocum/port_files/port_plan.h"

/// The check of a Slocum's port for a backseat driver (extctl).
namespace glider::slocum {

/// How long the parts of a check last, s of real time. Shorter ones are for tests: the vehicle's
/// clock advances by kCycleSecs in each cycle.
struct DockTimes {
  double listen_s = 10;  ///< for the other end, before something is sent
  double cycle_s = 4;    ///< of the played vehicle
  double whole_s = 180;
  double steer_s = 60;  ///< after that, if something is written to a vehicle
};

/// By the clock of the played vehicle, s.
inline constexpr double kCycleSecs = 4;

struct DockSetup {
  const PortPlan& plan;       ///< what the program knows
  const ExtctlFile& sensors;  ///< what the vehicle is given
  const platforms::Platform& platform;
  std::string program;  ///< its file in the folder
  vehicles::DockPart part = vehicles::DockPart::Auto;
  DockTimes times;
};

/// Runs the check on the line of `host`. Nothing is written to a vehicle unless host.confirm is
/// there and agrees; it is taken back at the end, also after host.stop.
vehicles::DockResult checkAtDock(const DockSetup& setup, const vehicles::DockHost& host);

}  // namespace glider::slocum
