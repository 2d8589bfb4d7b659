// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/flight_setup.h"

#include "driver/exit_code.h"
#include "driver/explain_guard.h"
#include "driver/terminal.h"
#include "ir/opt/optimise.h"

#include <algorithm>

namespace glider::driver {

std::unique_ptr<Compilation> compileForFlight(const std::string& mission, int& status) {
  auto compiled = compileMission(mission);
  if (!compiled) {
    status = reportFailure(compiled.error());
    return nullptr;
  }
  reportDiagnostics((*compiled)->diagnostics, (*compiled)->sources);
  status = (*compiled)->ok() ? kFine : kMissionHasErrors;
  if (status != kFine) {
    return nullptr;
  }
  ir::optimise(*(*compiled)->mission);  // as `build` does: the flight's states have those numbers
  return std::move(*compiled);
}

support::Result<platforms::Platform> platformOf(const Compilation* compilation) {
  if (compilation != nullptr && compilation->platform) {
    return *compilation->platform;
  }
  const std::string name = compilation != nullptr ? compilation->mission->platform : "slocum";
  return platforms::loadPlatform(platformFile(name));
}

void reportMissingSensors(const Compilation& compilation, const simulator::Scenario& scenario,
                          support::DiagnosticEngine& diagnostics) {
  for (const simulator::NotCarried& sensor : simulator::sensorsNotCarried(scenario)) {
    const bool read = std::ranges::any_of(compilation.mission->sensors, [&](const auto& used) {
      return used.symbol.empty() && used.vehicle_name == sensor.name;
    });
    if (read) {
      diagnostics.report(support::DiagnosticId::sensorNotCarried, {}, scenario.name, sensor.name,
                         "the scenario's file gives it one with " + sensor.setting);
    }
  }
}

void describeMission(simulator::SimulationSetup& setup, const Compilation& compilation) {
  setup.mission_name = compilation.mission->name;
  setup.state_names = stateNames(*compilation.mission);
  setup.explain = [&compilation](uint32_t list, uint32_t state, uint32_t fired_case) {
    return explainGuard(compilation, list, state, fired_case);
  };
}

}  // namespace glider::driver
