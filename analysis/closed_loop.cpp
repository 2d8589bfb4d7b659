// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/closed_loop.h"

#include "analysis/heard_flight.h"
#include "flights/launch_choice.h"
#include "flights/requirement_watch.h"
#include "simulator/simulator.h"
#include "support/diagnostics/ids/vehicle.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::analysis {
namespace {

using support::Result;

constexpr uint64_t kSeeds = 3;  ///< of each scenario

/// Flies a refuted mission in the simulator, scenario by scenario, until a flight violates the
/// requirement. A counterexample of the prover has any readings; this says whether an ordinary
/// flight shows the violation too. That none does proves nothing.
class LoopSearch {
 public:
  LoopSearch(const compiler::Optimised& flown, const ir::prove::RequirementVerdict& verdict,
             std::shared_ptr<const codegen::LoadedMission> loaded)
      : flown_(flown),
        requirement_(verdict.requirement),
        parameters_(verdict.run->parameters),
        loaded_(std::move(loaded)) {}

  Result<ClosedLoop> run() {
    ClosedLoop result;
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
      for (const std::string& scenario : scenariosInOrder()) {
        const auto when = fly(scenario, seed);
        if (!when && when.error().id == support::diagnostics::badDataFile) {
          continue;  // a bundled scenario of another vehicle: its batteries have other voltages
        }
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
  /// The time at which the flight violates the requirement; empty: it does not, or only once it has
  /// broken an assumption.
  Result<std::optional<double>> fly(const std::string& scenario, uint64_t seed) const {
    const auto flight = flyHeard(flown_, loaded_, parameters_, scenario, seed);
    if (!flight) {
      return std::unexpected(flight.error());
    }
    const auto found =
        flights::violationOf(flown_, requirement_, flight->ticks, parameters_, flight->trace);
    const auto broken =
        flights::firstBrokenAssumption(flown_, flight->ticks, parameters_, flight->trace);
    const bool counts = found && (!broken || *broken > found->mission_time);
    return counts ? std::optional(found->mission_time) : std::nullopt;
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
  return LoopSearch(mission, verdict,
                    std::make_shared<const codegen::LoadedMission>(std::move(*loaded)))
      .run();
}

}  // namespace glider::analysis
