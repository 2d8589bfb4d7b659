// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/heard_flight.h"

#include "flights/flight_setup.h"
#include "flights/sbc_choice.h"
#include "flights/scenario_choice.h"
#include "simulator/simulator.h"

#include <algorithm>
#include <utility>

namespace glider::analysis {

using simulator::SbcPort;

support::Result<support::Trace> fly(const compiler::Optimised& mission, simulator::StartSbc start,
                                    World world) {
  simulator::SimulationSetup setup;
  setup.platform = mission.platform();
  setup.scenario = std::move(world.scenario);
  setup.seed = world.seed;
  flights::describeMission(setup, mission);
  auto sbc = start();
  if (!sbc) {
    return std::unexpected(sbc.error());
  }
  setup.sbc = std::move(*sbc);
  setup.restart_sbc = std::move(start);
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
  (void)flights::equipFor(mission.mission, mission.platform(), *world);
  const auto end = flights::usualEnd(mission.platform());
  if (!end) {
    return std::unexpected(end.error());
  }
  flights::HeardTicks heard(mission.checked->mission());
  const bool keeps_time = !world->faults.empty();
  const auto start = [&, card = std::make_shared<flights::Card>(),
                      first = true]() mutable -> support::Result<std::unique_ptr<SbcPort>> {
    auto sbc = std::make_unique<flights::InProcessSbc>(loaded, parameters, card, keeps_time, *end);
    if (std::exchange(first, false)) {
      sbc->watch([&](const GliderContext& context, double now) { heard.look(context, now); });
    }
    return sbc;
  };
  auto trace = fly(mission, start, {std::move(*world), seed});
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
