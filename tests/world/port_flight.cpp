// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/world/port_flight.h"

#include "simulator/slocum/flight/skeleton.h"
#include "simulator/slocum/own_mission.h"
#include "support/check.h"
#include "support/files.h"
#include "tests/world/fleet.h"

#include <fmt/format.h>

#include <filesystem>
#include <unistd.h>
#include <utility>

namespace glider::tests {

PortFlight planned(const FlyingMission& mission, simulator::Scenario scenario,
                   const slocum::PortChoice& choice) {
  const auto plan = slocum::planFor(*mission.flown, choice);
  CHECK(plan.has_value(), "the mission has no room on the port");
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      fmt::format("glider-port-{}-{}.mi", ::getpid(), static_cast<int>(choice.release));
  CHECK(support::writeFileAtomically(file, slocum::printPortMission(*plan)).has_value(),
        "the mission file cannot be written");
  auto own = simulator::loadMissionFile(file, sources, diagnostics);
  std::filesystem::remove(file);
  CHECK(own.has_value() && diagnostics.sorted().empty(), "the mission file cannot be read");
  simulator::SlocumMission& flown = simulator::slocumMissionOf(scenario);
  flown.file = std::move(*own);
  flown.extctl = plan->extctl;
  flown.code_15 = choice.release == slocum::Release::MissionModes
                      ? simulator::Code15::MissionMode
                      : simulator::Code15::FarFromWaypoint;
  return {*plan, std::move(scenario)};
}

flights::PortEnd portEnd(const PortFlight& flight) {
  return {flight.plan.port, static_cast<uint32_t>(flight.plan.extctl.sensors().size()) - 1,
          flight.plan.extctl.baud};
}

simulator::SimulationSetup setupOf(const FlyingMission& mission, const PortFlight& flight,
                                   uint64_t seed) {
  simulator::SimulationSetup setup;
  setup.platform = slocum();
  setup.scenario = flight.scenario;
  setup.seed = seed;
  auto start = flights::startInProcess(mission.loaded,
                                       *flights::chooseParameters(mission.flown->mission, {}), true,
                                       nullptr, portEnd(flight));
  setup.sbc = *start();
  setup.restart_sbc = std::move(start);
  return setup;
}

}  // namespace glider::tests
