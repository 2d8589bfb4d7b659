// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/closed_loop.h"

#include "flights/flight_setup.h"
#include "flights/in_process_sbc.h"
#include "flights/launch_choice.h"
#include "flights/requirement_watch.h"
#include "flights/scenario_choice.h"
#include "simulator/simulator.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace glider::analysis {
namespace {

using support::Result;

constexpr uint64_t kSeeds = 3;  ///< of each scenario

/// The scenarios that come with glidercc, the default one first.
std::vector<std::string> worlds() {
  std::vector<std::string> names = flights::scenarioNames();
  std::ranges::stable_partition(names, [](const std::string& name) { return name == "default"; });
  return names;
}

class Search {
 public:
  Search(const compiler::Optimised& flown, const ir::prove::RequirementVerdict& verdict,
         std::shared_ptr<const codegen::LoadedMission> loaded)
      : flown_(flown),
        requirement_(verdict.requirement),
        parameters_(verdict.run->parameters),
        loaded_(std::move(loaded)) {}

  Result<ClosedLoop> run() {
    ClosedLoop result;
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
      for (const std::string& scenario : worlds()) {
        const auto when = fly(scenario, seed);
        if (!when) {
          return std::unexpected(when.error());
        }
        ++result.flights;
        if (*when) {
          result.breaking = BreakingFlight{scenario, seed, **when};
          return result;
        }
      }
    }
    return result;
  }

 private:
  /// The time at which the flight violates the requirement; empty: it does not.
  Result<std::optional<double>> fly(const std::string& scenario, uint64_t seed) const {
    auto world = flights::chooseScenario(scenario, flown_.platform());
    if (!world) {
      return std::unexpected(world.error());
    }
    simulator::SimulationSetup setup;
    setup.platform = flown_.platform();
    setup.scenario = std::move(*world);
    setup.seed = seed;
    flights::describeMission(setup, flown_);
    auto sbc = std::make_unique<flights::InProcessSbc>(
        loaded_, parameters_, std::make_shared<flights::Card>(), !setup.scenario.faults.empty());
    flights::RequirementWatch watch(flown_);
    sbc->watch(watch.watcher(parameters_));
    setup.sbc = std::move(sbc);
    const auto trace = simulator::simulate(std::move(setup));
    if (!trace) {
      return std::unexpected(trace.error());
    }
    const auto found = watch.violation(requirement_, *trace);
    return found ? std::optional(found->mission_time) : std::nullopt;
  }

  const compiler::Optimised& flown_;
  size_t requirement_;  ///< its number
  std::vector<double> parameters_;
  std::shared_ptr<const codegen::LoadedMission> loaded_;
};

}  // namespace

Result<ClosedLoop> searchClosedLoop(const compiler::Optimised& mission,
                                    const ir::prove::RequirementVerdict& verdict) {
  const bool flies = simulator::checkPlatform(mission.platform()).has_value();
  if (!verdict.run || !flights::RequirementWatch::canWatch(mission) || !flies) {
    return ClosedLoop{};  // the proof stands without a flight
  }
  auto loaded = flights::loadHere(mission, {});
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  return Search(mission, verdict,
                std::make_shared<const codegen::LoadedMission>(std::move(*loaded)))
      .run();
}

}  // namespace glider::analysis
