// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/closed_loop.h"

#include "analysis/heard_flight.h"
#include "flights/launch_choice.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"
#include "simulator/simulator.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace glider::analysis {
namespace {

using support::Result;

constexpr uint64_t kSeeds = 3;  ///< of each scenario

/// The true depth (m) at vehicle times that do not fall; NaN beyond the trace.
class TrueDepth {
 public:
  explicit TrueDepth(const support::Trace& trace)
      : trace_(trace), column_(trace.column("true_depth")) {}

  double at(double time) {
    while (row_ < trace_.rowCount() && trace_.at(row_, 0) < time) {
      ++row_;
    }
    const bool there = column_ >= 0 && row_ < trace_.rowCount();
    return there ? trace_.at(row_, column_) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const support::Trace& trace_;
  int column_;
  size_t row_ = 0;
};

class Search {
 public:
  Search(const compiler::Optimised& flown, const ir::prove::RequirementVerdict& verdict,
         std::shared_ptr<const codegen::LoadedMission> loaded)
      : flown_(flown),
        m_(flown.checked->mission()),
        requirement_(m_.requirements[verdict.requirement]),
        parameters_(verdict.run->parameters),
        loaded_(std::move(loaded)) {}

  Result<ClosedLoop> run() {
    ClosedLoop result;
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
      for (const std::string& scenario : scenariosInOrder()) {
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
    const auto flight = flyHeard(flown_, loaded_, parameters_, scenario, seed);
    if (!flight) {
      return std::unexpected(flight.error());
    }
    return judge(flight->ticks, flight->trace);
  }

  [[nodiscard]] std::optional<double> judge(const std::vector<flights::HeardTick>& ticks,
                                            const support::Trace& trace) const {
    ir::Interpreter interpreter(m_, flown_.checked->facts.stack_depth);
    const auto& platform = flown_.platform();
    ir::RequirementMonitor monitor(m_, requirement_, platform.world.surface_depth_m,
                                   ir::prove::depthSensor(m_, platform));
    TrueDepth depth(trace);
    for (size_t i = 0; i < ticks.size() && !monitor.when(); ++i) {
      const flights::HeardTick& tick = ticks[i];
      const auto result = i == 0 ? interpreter.start(tick.frame, parameters_)
                                 : interpreter.tick(tick.mission_time, tick.frame);
      monitor.tick(interpreter, tick.mission_time, result, depth.at(tick.vehicle_time));
    }
    return monitor.when();
  }

  const compiler::Optimised& flown_;
  const ir::Mission& m_;  ///< with its requirements
  const ir::Requirement& requirement_;
  std::vector<double> parameters_;
  std::shared_ptr<const codegen::LoadedMission> loaded_;
};

}  // namespace

Result<ClosedLoop> searchClosedLoop(const compiler::Optimised& mission,
                                    const ir::prove::RequirementVerdict& verdict) {
  const bool flies = simulator::checkPlatform(mission.platform()).has_value();
  if (!verdict.run || needsCodeInC(mission.checked->mission()) || !flies) {
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
