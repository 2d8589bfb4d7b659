// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"
#include "simulator/ocean/ocean.h"
#include "simulator/scenario/cycle_settings.h"
#include "simulator/sensors/sensor_list.h"
#include "simulator/vehicle/vehicle.h"
#include "support/diagnostics/engine.h"
#include "support/result.h"
#include "support/source_manager.h"

#include <any>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace glider::simulator {

/// A sensor that the operator or the science computer sets in flight, as u_mission_param_a.
struct Put {
  double at_s = 0;
  std::string sensor;
  double value = 0;
};

/// The longest time that a scenario may last, s: 60 days.
inline constexpr double kLongestFlight_s = 60 * 86400;

/// An environment, and a vehicle in it with the mission file that it flies: scenarios/<name>.toml.
struct Scenario {
  std::string name;
  std::string description;
  uint64_t seed = 1;
  double latitude_deg = 0, longitude_deg = 0;  ///< of the start
  double year = 2025;                          ///< of the magnetic field, with its fraction
  double duration_s = 0;                       ///< at most
  double isotherm_degC = 0;                    ///< NaN: none is marked
  std::filesystem::path path;                  ///< of the scenario file
  std::filesystem::path skeleton_path;         ///< of the vehicle's own mission
  std::any own;  ///< the vehicle's own mission, of the type of its family; empty: none was read
  CycleSettings cycles;
  std::vector<Put> puts;
  OceanSettings ocean;
  VehicleSettings vehicle;
  SensorSettings sensors;
  Faults faults;
};

/// Reads and checks scenario `path`, and the vehicle's own mission, if the platform is of a family
/// that the simulator knows. Its file is looked for in the folder of the scenario and then in
/// `bundled`, the folder of those that come with the program; empty: not there. What the scenario
/// does not say of the vehicle is `platform`'s. Fails with GL9001 or GL5001; errors in the mission
/// files go to `diagnostics`, and the failure is then GL5120.
support::Result<Scenario> loadScenario(const std::filesystem::path& path,
                                       const platforms::Platform& platform,
                                       support::SourceManager& sources,
                                       support::DiagnosticEngine& diagnostics,
                                       const std::filesystem::path& bundled = {});

}  // namespace glider::simulator
