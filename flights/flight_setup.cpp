// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/flight_setup.h"

#include "flights/explain_guard.h"

#include <algorithm>

namespace glider::flights {

support::Result<platforms::Platform> platformOf(const compiler::Optimised* mission) {
  return mission != nullptr ? mission->platform()
                            : platforms::loadPlatform(compiler::platformFile("slocum"));
}

void reportMissingSensors(const compiler::Optimised& mission, const simulator::Scenario& scenario,
                          support::DiagnosticEngine& diagnostics) {
  for (const simulator::NotCarried& sensor : simulator::sensorsNotCarried(scenario)) {
    const bool read = std::ranges::any_of(mission.mission.sensors, [&](const auto& used) {
      return used.symbol.empty() && used.vehicle_name == sensor.name;
    });
    if (read) {
      diagnostics.report(support::DiagnosticId::sensorNotCarried, {}, scenario.name, sensor.name,
                         sensor.setting);
    }
  }
}

void describeMission(simulator::SimulationSetup& setup, const compiler::Optimised& mission) {
  setup.mission_name = mission.mission.name;
  setup.state_names = compiler::stateNames(mission.mission);
  setup.explain = [&mission](uint32_t list, uint32_t state, uint32_t fired_case) {
    return explainGuard(mission, list, state, fired_case);
  };
}

}  // namespace glider::flights
