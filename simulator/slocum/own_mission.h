// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/scenario/scenario.h"
#include "simulator/slocum/flight/when.h"
#include "vehicles/slocum/mission_files/extctl_file.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <optional>
#include <string>
#include <vector>

namespace glider::simulator {

/// What a Slocum flies by itself: its mission file, and how its release reads it.
struct SlocumMission {
  slocum::MissionFile file;
  Code15 code_15 = Code15::FarFromWaypoint;
  /// The vehicle has no hooks, and serves the SBC by its port for a backseat driver.
  std::optional<slocum::ExtctlFile> extctl;
  /// The greatest depth that the program at that port commands, m; empty: only its builder knows.
  std::optional<double> program_depth_m;
  /// The program that acts as its science computer, and its arguments; empty: the simulator's own.
  std::vector<std::string> science_program;
};

/// The Slocum's mission in a scenario: an empty one is put there if it has none yet. The scenario
/// must be for a Slocum.
SlocumMission& slocumMissionOf(Scenario& scenario);
const SlocumMission& slocumMissionOf(const Scenario& scenario);

/// Its mission file.
inline slocum::MissionFile& missionFileOf(Scenario& scenario) {
  return slocumMissionOf(scenario).file;
}
inline const slocum::MissionFile& missionFileOf(const Scenario& scenario) {
  return slocumMissionOf(scenario).file;
}

}  // namespace glider::simulator
