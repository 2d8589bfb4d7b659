// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "runtime/abi/port_mission.h"
#include "support/result.h"
#include "vehicles/slocum/mission_files/extctl_file.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The files with which a Slocum as it is sold flies a mission by its port for a backseat driver
/// (extctl).
namespace glider::slocum {

/// How a release of the vehicle's software reads mission files.
enum class Release : uint8_t {
  Common,        ///< as release 10.05
  MissionModes,  ///< code 15 of start_when: a bit of u_mission_mode
};

/// What the pilot chooses.
struct PortChoice {
  Release release = Release::Common;
  double greatest_depth_m = 0;        ///< deeper targets are refused
  double least_altitude_m = 5;        ///< a dive ends this far above the bottom
  double surface_after_s = 4 * 3600;  ///< without contact for this long, the vehicle comes up
  uint32_t most_sensors = 32;         ///< on the port; newer vehicles take 64
  uint32_t baud = ExtctlFile::kUsualBaud;
};

/// surface_after_s of a port that can be planned, s.
inline constexpr double kLeastSurfaceAfter = 600, kMostSurfaceAfter = 7 * 86400;

/// The vehicle waits this long for its operator after it has come up by itself, s.
inline constexpr double kOperatorWait = 600;

/// overdepth of abend is this many overshoots of the vehicle below the greatest depth.
inline constexpr double kAbortsBelow = 2;

/// Between the ends of the yo that holds a depth, m.
double holdOf(const platforms::Platform& platform);

/// Everything that the files say.
struct PortPlan {
  std::string mission;  ///< its name
  std::string file;     ///< of the vehicle: eight letters at most, without the ending
  PortChoice choice;
  GliderPortMission port{};
  ExtctlFile extctl;
  double overshoot_m = 0;  ///< past a target depth, at most
  double overdepth_m = 0;  ///< the vehicle aborts its mission below: the last bound
};

/// Plans the files for a mission called `name` of a vehicle `platform`, which reads its sensors
/// `sensors` by their numbers in the platform file, in the order of the compiled mission. `content`
/// distinguishes this mission from others: the program on the SBC steers only while the vehicle
/// flies the files that were made with it. GL5131: the port has no room for all sensors.
support::Result<PortPlan> planPort(const std::string& name, std::string_view content,
                                   const platforms::Platform& platform,
                                   const std::vector<uint16_t>& sensors, const PortChoice& choice);

/// The mission file.
std::string printPortMission(const PortPlan& plan);

/// The entry of proglets.dat.
std::string printProglet(const PortPlan& plan);

}  // namespace glider::slocum
