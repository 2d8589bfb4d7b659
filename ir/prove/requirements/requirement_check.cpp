// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Decides the requirements of a mission by the strategies of strategies.def. In: what all passes
// before have left, and the budget Proof::searches, which no other pass takes from. Out:
// Findings::requirements; GL3111 for each that stays undecided. README.md has the arguments.

#include "ir/prove/requirements/requirement_check.h"

#include "ir/prove/requirements/advice.h"
#include "ir/prove/requirements/search_order.h"
#include "ir/prove/requirements/trace_search.h"
#include "support/diagnostics/ids/verification.h"
#include "support/units/duration_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace glider::ir::prove {
namespace {

/// What random flights have shown of a requirement that they did not violate.
std::string notViolatedBy(const std::vector<Flown>& flown, const Requirement& requirement) {
  std::vector<std::string> flights;
  for (const auto& [span_s, count] : flown) {
    if (count > 0) {
      flights.push_back(
          fmt::format("{} of up to {}", count, support::durationText(std::round(span_s))));
    }
  }
  return flights.empty() || requirement.kind == RequirementKind::Reach
             ? ""
             : fmt::format("; random flights did not violate it ({})", fmt::join(flights, ", "));
}

/// A limit is worth raising only where one was reached.
std::string whatMayHelp(std::string_view reason, const Options& options) {
  constexpr unsigned kWorthTrying = 4;  // less is rarely enough
  const unsigned more = std::min(kWorthTrying * options.raised, kMostRaised);
  return isCutShort(reason) && more > options.raised
             ? fmt::format("simplify the requirement, or let the search take longer: `--effort {}`",
                           more)
         : reason.contains("`--timeout`")
             ? "simplify the requirement, or allow more time with `--timeout`"
         : reason.contains("power table") ? "allow more energy, or let the mission take less"
                                          : "simplify the requirement, or what it depends on";
}

}  // namespace

RequirementCheck::RequirementCheck(StrategyContext& context) : context_(context) {
  if (context.bare != nullptr) {
    premises_.emplace(context);
  }
}

void RequirementCheck::run() {
  for (uint32_t i = 0; i < context_.mission.requirements.size(); ++i) {
    judged_.push_back(atOnce(i));
  }
  for (const uint32_t i : searchOrder(waiting(), context_.mission.requirements)) {
    if (context_.proof.options.before_requirement) {
      context_.proof.options.before_requirement(i);
    }
    search(judged_[i]);
    learn(judged_[i]);
  }
  for (const uint32_t i : searchOrder(waiting(), context_.mission.requirements)) {
    searchLonger(judged_[i]);
  }
  for (const uint32_t i : searchOrder(waiting(), context_.mission.requirements)) {
    flyForHours(judged_[i]);
  }
  for (Judged& judged : judged_) {
    settle(judged);
    addPremises(judged);
  }
  for (Judged& judged : judged_) {
    addEvidence(judged);
    context_.proof.findings.requirements.push_back(std::move(judged.verdict));
  }
}

/// What is proved without the assumptions rests on none of them.
RequirementCheck::Judged RequirementCheck::atOnce(uint32_t number) {
  Judged judged;
  judged.verdict.requirement = number;
  if (isAtOnceProvedBare(number, judged)) {
    return judged;
  }
  Attempt attempt{number, requirementOf(judged)};
  for (const auto& [strategy, phase] : strategies()) {
    if (phase != Phase::Search && judgeBy(strategy, attempt, judged)) {
      return judged;
    }
  }
  judged.waited = true;
  return judged;
}

bool RequirementCheck::isAtOnceProvedBare(uint32_t number, Judged& judged) {
  if (context_.bare == nullptr) {
    return false;
  }
  const Requirement& requirement = context_.bare->mission.requirements[number];
  for (const auto& [strategy, phase] : strategies()) {
    if (phase != Phase::Search && strategy.serves(requirement) &&
        strategy.proves(requirement, *context_.bare)) {
      judged = {{number, Verdict::Proved, std::nullopt}, &strategy, /*bare=*/true};
      return true;
    }
  }
  return false;
}

std::vector<uint32_t> RequirementCheck::waiting() const {
  std::vector<uint32_t> numbers;
  for (const Judged& judged : judged_) {
    if (judged.waited) {
      numbers.push_back(judged.verdict.requirement);
    }
  }
  return numbers;
}

void RequirementCheck::search(Judged& judged) {
  Budget& budget = context_.proof.searches;
  if (judgeAgain(judged)) {
    return;
  }
  Attempt attempt{judged.verdict.requirement, requirementOf(judged)};
  if (budget.isUsedUp()) {
    judged.verdict.reason = "it was not searched for: " + context_.limitReached();
    return;
  }
  context_.flown = {};
  if (!judgeBySearch(attempt, judged)) {
    judged.verdict.reason = attempt.reason + notViolatedBy(context_.flown, attempt.requirement);
  }
  // For Reach its trace is needed; what was cut short hangs on what was searched for before.
  judged.verdict.searched |=
      attempt.requirement.kind != RequirementKind::Reach && !budget.isUsedUp();
}

/// With what is left once all have been searched for: most are decided in a small part of it.
void RequirementCheck::searchLonger(Judged& judged) {
  if (judged.verdict.verdict != Verdict::Open || !isCutShort(judged.verdict.reason) ||
      context_.proof.searches.isUsedUp()) {
    return;
  }
  const unsigned effort =
      std::exchange(context_.search_effort, StrategyContext::kLonger * context_.search_effort);
  if (context_.bare != nullptr) {
    context_.bare->search_effort = context_.search_effort;
  }
  Attempt attempt{judged.verdict.requirement, requirementOf(judged)};
  attempt.reason = judged.verdict.reason;
  if (judgeBy(strategy::otherLemmas(), attempt, judged) ||
      judgeBy(strategy::allTraces(), attempt, judged) ||
      (attempt.with_power_cuts && judgeBy(strategy::withoutPowerCuts(), attempt, judged)) ||
      judgeBy(strategy::traceWithPowerCuts(), attempt, judged) ||
      judgeBy(strategy::withoutAssumptions(), attempt, judged) ||
      judgeBy(strategy::counted(), attempt, judged)) {
    judged.verdict.searched = true;
    learn(judged);
  }
  context_.search_effort = effort;
  if (context_.bare != nullptr) {
    context_.bare->search_effort = effort;
  }
  // What was cut short hangs on what was searched for before.
  judged.verdict.searched &= !context_.proof.searches.isUsedUp();
}

/// At last, as nothing is searched for after it. Without power cuts first: such a flight is easier
/// to understand.
void RequirementCheck::flyForHours(Judged& judged) {
  const Requirement& requirement = requirementOf(judged);
  if (judged.verdict.verdict != Verdict::Open || !isPromiseOfTraces(requirement) ||
      context_.proof.searches.isUsedUp()) {
    return;
  }
  context_.flown = {};
  const ProofContext& proof_context = context_.proof.proof_context;
  auto run = tryForHours(requirement, proof_context.withoutPowerCuts(), context_);
  if (!run && context_.powerCutsMatter()) {
    run = tryForHours(requirement, proof_context, context_);
  }
  if (run) {
    const uint32_t number = judged.verdict.requirement;
    judged.verdict = refutedBy(*std::move(run), requirement, context_);
    judged.verdict.requirement = number;
    judged.by = &strategy::randomFlights();
  } else if (!context_.flown.empty()) {
    judged.verdict.reason +=
        fmt::format(", nor did {} more of up to {}", context_.flown.front().count,
                    support::durationText(std::round(context_.flown.front().span_s)));
  }
}

/// By what other requirements have told, if they were proved after the first look.
bool RequirementCheck::judgeAgain(Judged& judged) {
  for (const auto& [strategy, phase] : strategies()) {
    if (context_.learnt && phase == Phase::AtOnceAndAgain &&
        strategy.serves(requirementOf(judged)) &&
        strategy.proves(requirementOf(judged), context_)) {
      judged.verdict = {judged.verdict.requirement, Verdict::Proved, std::nullopt};
      judged.by = &strategy;
      return true;
    }
  }
  return false;
}

bool RequirementCheck::judgeBySearch(Attempt& attempt, Judged& judged) {
  return std::ranges::any_of(strategies(), [&](const StrategyRow& row) {
    return row.phase == Phase::Search && judgeBy(row.strategy, attempt, judged);
  });
}

bool RequirementCheck::judgeBy(const Strategy& strategy, Attempt& attempt, Judged& judged) {
  auto verdict =
      strategy.serves(attempt.requirement) ? strategy.judge(attempt, context_) : std::nullopt;
  if (!verdict) {
    return false;
  }
  judged.verdict = *std::move(verdict);
  judged.verdict.requirement = attempt.number;
  judged.by = &strategy;
  return true;
}

void RequirementCheck::learn(const Judged& judged) {
  const Requirement& requirement = requirementOf(judged);
  // What rests on a premise of its own proves nothing else.
  if (judged.verdict.verdict == Verdict::Proved && requirement.geofences.empty() &&
      judged.verdict.premise.empty()) {
    context_.insight().know(requirement);
    context_.learnt = true;
  }
}

/// A requirement left undecided may follow from one that was proved after it.
void RequirementCheck::settle(Judged& judged) {
  if (judged.verdict.verdict != Verdict::Open || judgeAgain(judged)) {
    return;
  }
  const Requirement& requirement = requirementOf(judged);
  auto warning =
      context_.proof.diagnostics.report(support::diagnostics::requirementOpen, requirement.range,
                                        whatMayHelp(judged.verdict.reason, context_.proof.options));
  warning.note(requirement.range, judged.verdict.reason);
  const ProofContext& proof_context = context_.proof.proof_context;
  if (requirement.kind == RequirementKind::SurfacesEvery) {
    noteEarlyLeaves(warning, proof_context);
    noteOwnSurfacings(warning, proof_context);
    noteTimerBelow(warning, requirement, proof_context);
  } else if (requirement.seconds > 0) {
    noteLateEnd(warning, requirement, proof_context);
  }
  if (requirement.kind == RequirementKind::ExitWithin) {
    notePowerCutsCount(warning, requirement, proof_context, context_.proof.ending);
  }
  noteSlowClimb(warning, requirement, proof_context);
  notePutOff(warning, requirement, proof_context);
  noteFences(warning, requirement, proof_context);
  noteUnlimitedCounts(warning, proof_context);
  noteTimersOfEntries(warning, proof_context);
  noteCalendar(warning, requirement, proof_context);
}

/// A flight that reaches a state does so under any assumptions (but see prove()).
void RequirementCheck::addPremises(Judged& judged) {
  if (premises_ && !judged.bare && judged.verdict.verdict == Verdict::Proved &&
      !judged.verdict.run) {
    premises_->name(judged.verdict, *judged.by);
  }
}

/// Of the proofs that have none yet.
void RequirementCheck::addEvidence(Judged& judged) {
  if (!context_.wantsEvidence() || judged.verdict.verdict != Verdict::Proved ||
      judged.verdict.evidence) {
    return;
  }
  StrategyContext& context = judged.bare ? *context_.bare : context_;
  judged.verdict.evidence = judged.by->evidence(
      context.mission.requirements[judged.verdict.requirement], judged.waited, context);
}

const Requirement& RequirementCheck::requirementOf(const Judged& judged) const {
  return context_.mission.requirements[judged.verdict.requirement];
}

}  // namespace glider::ir::prove
