// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/sbc_choice.h"
#include "platforms/load/board.h"
#include "simulator/scenario/scenario.h"
#include "support/result.h"
#include "vehicles/slocum/port_files/port_plan.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glider::driver {

/// The options of `glidercc build --dialect extctl`.
struct PortOptions {
  std::string release = "10.05";
  std::optional<double> greatest_depth_m;  ///< empty: the deepest that the mission commands
  std::optional<double> surface_after_s;
  uint32_t sensors = 32;
  bool ignore_limits = false;  ///< of the board
};

/// The missions in a folder that build has written.
struct PortFolder {
  std::filesystem::path mission;          ///< of the language
  std::filesystem::path vehicle_mission;  ///< of the vehicle
};

/// Writes everything with which a Slocum without the hooks flies the mission into `folder`: all
/// files, or none. Shows what the port cannot do. GL4015 is counted in the result: false, and
/// nothing is written.
support::Result<bool> writePortFolder(const PortOptions& options,
                                      const std::filesystem::path& folder,
                                      const std::string& mission_file,
                                      const platforms::Board& board,
                                      const std::vector<std::string>& user_code,
                                      const compiler::Optimised& mission);

/// Whether `path` is a folder with what writePortFolder writes.
bool isPortFolder(const std::filesystem::path& path);
/// Reads it. GL5001, GL9001.
support::Result<PortFolder> openPortFolder(const std::filesystem::path& path);
/// If `path` is such a folder, reads it; empty if it is not.
support::Result<std::optional<PortFolder>> portFolderAt(const std::filesystem::path& path);

/// The vehicle of `scenario` is as `folder` says: it reads its mission file as the release for
/// which that was written, and the program at its port commands at most the depth with which it was
/// built.
support::Result<void> useChoice(const std::filesystem::path& folder, simulator::Scenario& scenario);

/// What a folder says of the port.
struct FolderPort {
  slocum::PortPlan plan;       ///< what the program knows
  slocum::ExtctlFile sensors;  ///< what the vehicle is to be given
};

/// For the mission in `folder`. GL4016 if the vehicle's mission file there was written for another
/// one, or with other options; GL5130.
support::Result<FolderPort> readFolderPort(const std::filesystem::path& folder,
                                           const compiler::Optimised& mission);

/// The program's end of the port, for the mission in `folder`. GL4016 if the vehicle's mission file
/// there was written for another one, or with other options.
support::Result<flights::PortEnd> portEndOf(const std::filesystem::path& folder,
                                            const compiler::Optimised& mission);

}  // namespace glider::driver
