// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/campaign/judge.h"
#include "simulator/campaign/promises.h"
#include "simulator/scenario/scenario.h"
#include "support/diagnostics/show.h"
#include "support/result.h"
#include "support/source_manager.h"
#include "vehicles/own_mission.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// What glidercc knows of a family of vehicles beyond its platform files and its simulation
/// (simulator/family): a constant of data and functions for each row of vehicles.def.
namespace glider::vehicles {

/// A flight that is to be checked.
struct FlightToJudge {
  const platforms::Platform& platform;
  const simulator::Scenario& scenario;
  const std::vector<simulator::FaultKind>& kinds;  ///< of the scenario's faults
  double mean_W = 0;  ///< of the same mission's flight without a fault; 0: not known
};

struct Vehicle {
  std::string_view name;
  /// The computers that its sensors are read from (platforms::Computer), as people call them.
  std::string_view flight_computer, science_computer;
  /// How the names of its own mission files end: ".mi".
  std::string_view own_mission_ending;
  /// Reads the vehicle's own mission at `path` into `sources`. A failure names the file; its errors
  /// are shown with `show`, if that is given.
  support::Result<std::unique_ptr<OwnMission>> (*read_own_mission)(
      const std::string& path, support::SourceManager& sources,
      const support::ShowDiagnostics& show);
  /// What is usual, for a mission that is checked without a file of the vehicle.
  std::unique_ptr<OwnMission> (*usual_own_mission)();
  /// Checks a flight of a campaign.
  std::unique_ptr<simulator::Judge> (*make_judge)(const FlightToJudge& flight);
  /// Whether that check expects anything of the vehicle in `scenario` with a fault of this kind.
  /// The kinds of which it expects nothing are not drawn alone.
  bool (*promises)(simulator::FaultKind kind, const simulator::Scenario& scenario);
};

/// The family of a platform; null if it names none that is known.
const Vehicle* vehicleOf(const platforms::Platform& platform);

/// The family whose own mission files end as this name does, in capitals or not; if none does,
/// `other`, or the first if that is null.
const Vehicle& vehicleOfFile(std::string_view path, const Vehicle* other = nullptr);

/// Whether the vehicle's own mission at `path` can be read; its errors are shown with `show`.
support::Result<void> tryOwnMission(const std::string& path, const support::ShowDiagnostics& show);
/// Whether it can, and missions can be flown with it in any scenario.
support::Result<void> tryInFlight(const std::string& path);

/// The vehicles of vehicles.def.
namespace families {
#define FAMILY(name) extern const Vehicle name;
#include "vehicles/vehicles.def"
#undef FAMILY
}  // namespace families

}  // namespace glider::vehicles
