// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/heard_flight.h"

#include "flights/flight_setup.h"
#include "flights/scenario_choice.h"
#include "simulator/simulator.h"

#include <algorithm>
#include <utility>

namespace glider::analysis {

support::Result<support::Trace> flyInProcess(const compiler::Optimised& mission,
                                             std::shared_ptr<const codegen::LoadedMission> loaded,
                                             const std::vector<double>& parameters, World world,
                                             flights::InProcessSbc::Watcher watcher) {
  simulator::SimulationSetup setup;
  setup.platform = mission.platform();
  setup.scenario = std::move(world.scenario);
  setup.seed = world.seed;
  flights::describeMission(setup, mission);
  auto sbc = std::make_unique<flights::InProcessSbc>(std::move(loaded), parameters,
                                                     std::make_shared<flights::Card>(),
                                                     !setup.scenario.faults.empty());
  if (watcher) {
    sbc->watch(std::move(watcher));
  }
  setup.sbc = std::move(sbc);
  return simulator::simulate(std::move(setup));
}

support::Result<HeardFlight> flyHeard(const compiler::Optimised& mission,
                                      std::shared_ptr<const codegen::LoadedMission> loaded,
                                      const std::vector<double>& parameters,
                                      const std::string& scenario, uint64_t seed) {
  auto world = flights::chooseScenario(scenario, mission.platform());
  if (!world) {
    return std::unexpected(world.error());
  }
  flights::HeardTicks heard(mission.checked->mission());
  auto trace =
      flyInProcess(mission, std::move(loaded), parameters, {std::move(*world), seed},
                   [&](const GliderContext& context, double now) { heard.look(context, now); });
  if (!trace) {
    return std::unexpected(trace.error());
  }
  return HeardFlight{heard.ticks(), std::move(*trace)};
}

std::vector<std::string> scenariosInOrder() {
  std::vector<std::string> names = flights::scenarioNames();
  std::ranges::stable_partition(names, [](const std::string& name) { return name == "default"; });
  return names;
}

}  // namespace glider::analysis
