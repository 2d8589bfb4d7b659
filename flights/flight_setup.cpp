// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/flight_setup.h"

#include "flights/explain_guard.h"
#include "flights/mission_facts.h"
#include "flights/scenario_choice.h"
#include "simulator/family/family.h"
#include "simulator/sensors/provided.h"
#include "support/diagnostics/ids/vehicle.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::flights {

namespace {

void reportUnsimulated(const compiler::Optimised& mission, support::DiagnosticEngine& diagnostics) {
  const simulator::Family* family = simulator::familyOf(mission.platform());
  for (const ir::Sensor& used : mission.mission.sensors) {
    const platforms::PlatformSensor* sensor = mission.platform().find(used.vehicle_name);
    const bool simulated = family != nullptr && sensor != nullptr && family->provides(*sensor);
    if (used.isOfVehicle() && !simulated) {
      diagnostics.report(support::diagnostics::sensorNotSimulated, {}, mission.platform().name,
                         used.vehicle_name);
    }
  }
}

/// "scenario `bloom`, whose vehicle carries it".
std::string whereCarried(const platforms::Platform& platform, std::string_view sensor) {
  const std::vector<std::string> names = scenariosWith(platform, sensor);
  return names.empty() ? "a scenario whose vehicle carries it"
                       : fmt::format("scenario `{}`, whose vehicle carries it", names.front());
}

/// The sensors of the vehicle that are sent to the mission.
std::vector<std::string> missionSensors(const ir::Mission& mission) {
  std::vector<std::string> names;
  for (const ir::Sensor& sensor : mission.sensors) {
    if (sensor.isOfVehicle()) {
      names.push_back(sensor.vehicle_name);
    }
  }
  return names;
}

}  // namespace

void reportMissingSensors(const compiler::Optimised& mission, const simulator::Scenario& scenario,
                          support::DiagnosticEngine& diagnostics) {
  for (const simulator::NotCarried& sensor : simulator::sensorsNotCarried(scenario)) {
    const bool read = std::ranges::any_of(mission.mission.sensors, [&](const auto& used) {
      return used.symbol.empty() && used.vehicle_name == sensor.name;
    });
    if (read) {
      diagnostics.report(support::diagnostics::sensorNotCarried, {}, scenario.name, sensor.name,
                         sensor.setting, whereCarried(mission.platform(), sensor.name));
    }
  }
  reportUnsimulated(mission, diagnostics);
}

bool needsCodeInC(const ir::Mission& mission) {
  return !mission.functions.empty() ||
         std::ranges::any_of(mission.sensors,
                             [](const ir::Sensor& s) { return !s.symbol.empty(); }) ||
         std::ranges::any_of(mission.behaviours,
                             [](const ir::Behaviour& b) { return !b.symbol.empty(); });
}

void describeMission(simulator::SimulationSetup& setup, const compiler::Optimised& mission) {
  setup.mission_name = mission.mission.name;
  setup.state_names = compiler::stateNames(mission.mission);
  setup.record = listedSensors(mission.mission);
  setup.read = missionSensors(mission.mission);
  setup.explain = [&mission](uint32_t list, uint32_t state, uint32_t fired_case) {
    return explainGuard(mission, list, state, fired_case);
  };
}

}  // namespace glider::flights
