// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/tables/scenario_tables.h"
#include "support/diagnostics/engine.h"
#include "support/result.h"
#include "support/source_manager.h"

#include <any>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace glider::simulator {

struct DrawnFaults;
struct SeatSetup;
class SimulatedSeat;

/// What the simulator has to know of a family of vehicles. Its own mission, what the vehicle flies
/// by itself beside the SBC, is of a type that only the family knows.
struct Family {
  std::string_view name;
  /// What flies the vehicle while the SBC is not in control, for reports.
  std::string_view own_control;
  /// The first sensor that its simulated computers need and a platform lacks; empty: none.
  std::string_view (*missing_sensor)(const platforms::Platform& platform);
  /// Whether they set a sensor of the platform.
  bool (*provides)(const platforms::PlatformSensor& sensor);
  /// Reads the vehicle's own mission from `path`, with what belongs to it, into `own`, which keeps
  /// what `read_vehicle` has set, and checks that the simulator can fly it. Fails with GL9001;
  /// errors in the files go to `diagnostics`, and the failure is then GL5120.
  support::Result<void> (*load_own)(const std::filesystem::path& path,
                                    support::SourceManager& sources,
                                    support::DiagnosticEngine& diagnostics, std::any& own);
  /// The keys of a scenario's table [vehicle] that only this family has; sets them in `own`.
  std::span<const std::string_view> vehicle_keys;
  void (*read_vehicle)(Fields& fields, std::any& own);
  /// The own mission as text: the same text, the same flight.
  std::string (*text_of)(const std::any& own);
  /// What a campaign has drawn for the own mission.
  void (*apply_drawn)(const DrawnFaults& drawn, std::any& own);
  /// The time after which the own mission ends by itself, s; 0: never.
  double (*overtime_of)(const std::any& own);
  /// Raises that time to `seconds` if it is sooner; returns what it was, empty if it was not.
  std::optional<double> (*raise_overtime)(std::any& own, double seconds);
  /// Raises the time for which the own mission lets the SBC sleep to `seconds`; returns what it is
  /// then, empty if it was enough. Null: the SBC never sleeps.
  std::optional<double> (*raise_nap_secs)(std::any& own, double seconds) = nullptr;
  std::unique_ptr<SimulatedSeat> (*make_seat)(const SeatSetup& setup);
};

/// The families of vehicles/vehicles.def.
namespace families {
#define FAMILY(name) extern const Family name;
#include "vehicles/vehicles.def"
#undef FAMILY
}  // namespace families

/// The family of a vehicle; null if the platform names none that the simulator knows.
const Family* familyOf(const platforms::Platform& platform);

/// "only `slocum`".
std::string knownFamilies();

}  // namespace glider::simulator
