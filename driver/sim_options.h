// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/launch_choice.h"
#include "flights/requirement_watch.h"
#include "platforms/load/default_platform.h"
#include "report/picture/picture.h"
#include "simulator/simulator.h"
#include "support/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glider::driver {

/// The options of `glidercc sim`.
struct SimOptions {
  bool json = false;    ///< --format json
  std::string mission;  ///< or a fleet file
  std::string only;     ///< the one vehicle of the fleet that flies; empty: all
  std::string scenario = "default";
  /// MISSION, if it is a folder for a vehicle's port: `mission` and `mi` are those in it.
  std::string port_folder;
  std::string mi;  ///< the vehicle's mission file; empty: the scenario's
  std::string platform{platforms::kDefaultPlatform};  ///< used if no mission names one
  std::string board;
  std::optional<uint16_t> debugger;  ///< with `board`: its binary waits for one on this TCP port
  std::string program;
  std::string serial;                  ///< the device to which a real SBC is connected; empty: none
  bool lockstep = false;               ///< with --serial: not in real time
  std::optional<std::string> science;  ///< the program that acts as the science computer
  bool without_sbc = false;
  std::optional<uint64_t> seed;
  std::optional<double> kill_sbc_at_s;
  std::optional<double> duration_s;  ///< of the flight at most; empty: the scenario's
  std::string output;
  std::string replay;            ///< the file of a trace; empty: none
  std::string picture;           ///< the file of a picture; empty: none
  std::string chart = "depths";  ///< of a fleet, on the picture
  std::string kml;               ///< these too
  std::string geojson;
  std::string netcdf;
  report::PictureStyle picture_style;
  flights::LaunchChoice launch;
  std::vector<std::string> user_code;
};

/// The stem of the flight's file names: that of the mission's file, the program or the serial
/// device, or another valid name.
std::string flightName(const SimOptions& options);

/// The folder that the user named, or one named after the mission.
std::string outputFolder(const SimOptions& options);

/// Whether MISSION is one of the vehicle's own, a .mi file, and not one of the language.
bool isVehiclesOwn(const SimOptions& options);

/// Whether the mission flies in this process.
bool isInProcess(const SimOptions& options);

/// Returns what starts the SBC, empty for none; `keeps_time`: as for a flight with faults. A
/// board's binary is built into `folder`. `watch` (null: none) watches the mission, in this process
/// or beside the board or the program, and outlives the flight.
support::Result<simulator::StartSbc> chooseSbc(const SimOptions& options,
                                               const compiler::Optimised* mission, bool keeps_time,
                                               const std::filesystem::path& folder,
                                               flights::RequirementWatch* watch);

}  // namespace glider::driver
