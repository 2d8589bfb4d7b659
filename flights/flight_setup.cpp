// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/flight_setup.h"

#include "flights/explain_guard.h"

#include <algorithm>

namespace glider::flights {

support::Result<platforms::Platform> platformOf(const compiler::Compilation* compilation) {
  if (compilation != nullptr && compilation->platform) {
    return *compilation->platform;
  }
  const std::string name = compilation != nullptr ? compilation->mission->platform : "slocum";
  return platforms::loadPlatform(compiler::platformFile(name));
}

void reportMissingSensors(const compiler::Compilation& compilation,
                          const simulator::Scenario& scenario,
                          support::DiagnosticEngine& diagnostics) {
  for (const simulator::NotCarried& sensor : simulator::sensorsNotCarried(scenario)) {
    const bool read = std::ranges::any_of(compilation.mission->sensors, [&](const auto& used) {
      return used.symbol.empty() && used.vehicle_name == sensor.name;
    });
    if (read) {
      diagnostics.report(support::DiagnosticId::sensorNotCarried, {}, scenario.name, sensor.name,
                         sensor.setting);
    }
  }
}

void describeMission(simulator::SimulationSetup& setup, const compiler::Compilation& compilation) {
  setup.mission_name = compilation.mission->name;
  setup.state_names = compiler::stateNames(*compilation.mission);
  setup.explain = [&compilation](uint32_t list, uint32_t state, uint32_t fired_case) {
    return explainGuard(compilation, list, state, fired_case);
  };
}

}  // namespace glider::flights
