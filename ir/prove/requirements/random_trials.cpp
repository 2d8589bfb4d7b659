// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/random_trials.h"

#include "ir/prove/falsification/random_flight.h"

#include <algorithm>
#include <utility>

namespace glider::ir::prove {
namespace {

/// For a requirement without a time, s.
constexpr double kLongFlight = 4 * 3600;
/// Flights without a simpler counterexample after which the simplest is taken.
constexpr uint64_t kSimplerTries = 200;

struct Trials {
  size_t ticks;         ///< of a flight
  size_t flights;       ///< how many
  uint64_t tick_steps;  ///< what a tick takes from the budget
};

Trials trialsOf(const Requirement& requirement, const StrategyContext& context) {
  const Mission& m = context.mission;
  const double cycle = context.proof.proof_context.platform.envelope.cycle_s;
  const double time = std::max(requirement.seconds, requirement.monitor.horizon_s);
  const double span = time > 0 ? 2 * time : kLongFlight;
  const uint64_t tick = Budget::kTick + m.exprs.size() / Budget::kExpressions;
  const uint64_t judged = requirement.condition.valid()
                              ? Evaluation(m, requirement.condition).size() / Budget::kEvaluated
                              : 0;
  // A condition with very many operations, such as an area with 1,000 corners, is tried on fewer
  // ticks.
  const size_t most =
      context.proof.options.random_ticks * 2 * tick / std::max(2 * tick, tick + judged);
  const auto ticks = static_cast<size_t>(std::min(span / cycle + 2, static_cast<double>(most)));
  return {ticks, std::max<size_t>(1, most / ticks), tick + judged};
}

/// Fewer transitions are easier to follow, then less time. A flight that starts in the wrong place
/// shows nothing about the mission.
bool isSimpler(const Counterexample& one, const Counterexample& other) {
  return (one.when > 0 || other.when <= 0) &&
         std::pair(one.story.size(), one.when) < std::pair(other.story.size(), other.when);
}

}  // namespace

std::optional<Counterexample> tryAtRandom(const Requirement& requirement,
                                          const ProofContext& proof_context,
                                          StrategyContext& context, unsigned round) {
  const Trials trials = trialsOf(requirement, context);
  Budget& budget = context.proof.searches;
  const Requirement* place = aboutPlaceOf(proof_context, std::span(&requirement, 1));
  const uint64_t before = round * trials.flights;
  for (uint64_t seed = before + 1; seed <= before + trials.flights && !budget.isUsedUp(); ++seed) {
    budget.spend(trials.ticks * trials.tick_steps);
    if (auto run = flyAtRandom(proof_context, context.proof.facts.stack_depth, requirement, place,
                               seed, trials.ticks)) {
      return simplest(*std::move(run), requirement, proof_context, context);
    }
  }
  return std::nullopt;
}

Counterexample simplest(Counterexample found, const Requirement& requirement,
                        const ProofContext& proof_context, StrategyContext& context) {
  if (requirement.kind == RequirementKind::ExitWithin ||
      requirement.kind == RequirementKind::SurfacesEvery) {
    return found;  // it lasts as long as the requirement allows
  }
  const Trials trials = trialsOf(requirement, context);
  Budget& budget = context.proof.searches;
  const Requirement* place = aboutPlaceOf(proof_context, std::span(&requirement, 1));
  size_t left = context.proof.options.random_ticks / 4;
  uint64_t last = kSimplerTries;
  for (uint64_t seed = 1; seed <= last && !budget.isUsedUp(); ++seed) {
    const size_t ticks = std::min({found.ticks.size(), trials.ticks, left});
    budget.spend(ticks * trials.tick_steps);
    left -= ticks;
    auto run = flyAtRandom(proof_context, context.proof.facts.stack_depth, requirement, place, seed,
                           ticks);
    if (run && isSimpler(*run, found)) {
      found = *std::move(run);
      last = seed + kSimplerTries;
    }
  }
  return found;
}

}  // namespace glider::ir::prove
