// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/random_trials.h"

#include "ir/core/types.h"
#include "ir/prove/falsification/random_flight.h"

#include <algorithm>
#include <utility>

namespace glider::ir::prove {
namespace {

/// For a requirement without a time, s.
constexpr double kLongFlight = 4 * 3600;
/// Of the times that a mission names, those beyond this are dates, s.
constexpr double kLongestNamed = 366 * 86400.0;
/// So many times more flights are begun where some are given up soon.
constexpr uint64_t kGivenUp = 30;
/// Flights without a simpler counterexample after which the simplest is taken.
constexpr uint64_t kSimplerTries = 200;

struct Trials {
  FlightLength length;  ///< of a flight
  double span;          ///< the time that this takes, s
  size_t flights;       ///< how many
  uint64_t tick_steps;  ///< what a tick takes from the budget
};

/// The longest time that the mission names, s: what it compares clocks and timers with.
double longestTimeIn(const Mission& m) {
  double longest = 0;
  for (const Expr& e : m.exprs) {
    if (e.op == Op::Constant && e.type == quantity(support::dimension::time) &&
        e.number <= kLongestNamed) {
      longest = std::max(longest, e.number);
    }
  }
  return longest;
}

/// Flights of `span` s.
Trials trialsOf(const Requirement& requirement, const StrategyContext& context, double span,
                bool sparse) {
  const Mission& m = context.mission;
  const platforms::Platform& platform = context.proof.proof_context.platform;
  const double cycle = sparse ? platform.world.tick_gap_s : platform.envelope.cycle_s;
  const uint64_t tick = Budget::kTick + m.exprs.size() / Budget::kExpressions;
  const uint64_t judged = requirement.condition.valid()
                              ? Evaluation(m, requirement.condition).size() / Budget::kEvaluated
                              : 0;
  // A condition with very many operations, such as an area with 1,000 corners, is tried on fewer
  // ticks.
  const size_t most =
      context.proof.options.random_ticks * 2 * tick / std::max(2 * tick, tick + judged);
  const auto ticks = static_cast<size_t>(std::min(span / cycle + 2, static_cast<double>(most)));
  return {{ticks, sparse},
          std::min(span, static_cast<double>(ticks) * cycle),
          std::max<size_t>(1, most / ticks),
          tick + judged};
}

Trials trialsOf(const Requirement& requirement, const StrategyContext& context) {
  const double time = std::max(requirement.seconds, requirement.monitor.horizon_s);
  return trialsOf(requirement, context, time > 0 ? 2 * time : kLongFlight, false);
}

/// Of the seeds after `before`; the first that violates (Reach: satisfies) the requirement.
std::optional<Counterexample> fly(const Trials& trials, const Requirement& requirement,
                                  const ProofContext& proof_context, StrategyContext& context,
                                  uint64_t before) {
  Budget& budget = context.proof.searches;
  const Requirement* place = aboutPlaceOf(proof_context, std::span(&requirement, 1));
  if (context.flown.empty() || context.flown.back().span_s != trials.span) {
    context.flown.push_back({trials.span});
  }
  const uint64_t last = before + trials.flights * (trials.length.sparse ? kGivenUp : 1);
  size_t left = trials.flights * trials.length.ticks;
  for (uint64_t seed = before + 1; seed <= last && left > 0 && !budget.isUsedUp(); ++seed) {
    Flight flight = flyAtRandom(proof_context, context.proof.facts.stack_depth, requirement, place,
                                seed, trials.length);
    const size_t taken = trials.length.sparse ? flight.ticks + 1 : trials.length.ticks;
    budget.spend(taken * trials.tick_steps);
    left -= std::min(left, taken);
    context.flown.back().count += flight.given_up ? 0 : 1;
    if (flight.violation) {
      return std::move(flight.violation);
    }
  }
  return std::nullopt;
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
  auto run = fly(trials, requirement, proof_context, context, round * trials.flights);
  return run ? std::optional(simplest(*std::move(run), requirement, proof_context, context))
             : std::nullopt;
}

std::optional<Counterexample> tryForLong(const Requirement& requirement,
                                         const ProofContext& proof_context,
                                         StrategyContext& context) {
  const double span = 2 * longestTimeIn(context.mission);
  return span > kLongFlight ? fly(trialsOf(requirement, context, span, /*sparse=*/true),
                                  requirement, proof_context, context, 0)
                            : std::nullopt;
}

std::optional<Counterexample> tryForHours(const Requirement& requirement,
                                          const ProofContext& proof_context,
                                          StrategyContext& context) {
  const double time = std::max(requirement.seconds, requirement.monitor.horizon_s);
  if (time <= 0 || 4 * time > kLongFlight) {
    return std::nullopt;
  }
  auto run = fly(trialsOf(requirement, context, kLongFlight, /*sparse=*/false), requirement,
                 proof_context, context, 0);
  return run ? std::optional(simplest(*std::move(run), requirement, proof_context, context))
             : std::nullopt;
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
    const size_t ticks = std::min({found.ticks.size(), trials.length.ticks, left});
    budget.spend(ticks * trials.tick_steps);
    left -= ticks;
    auto run = flyAtRandom(proof_context, context.proof.facts.stack_depth, requirement, place, seed,
                           {ticks})
                   .violation;
    if (run && isSimpler(*run, found)) {
      found = *std::move(run);
      last = seed + kSimplerTries;
    }
  }
  return found;
}

}  // namespace glider::ir::prove
