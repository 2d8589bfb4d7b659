// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The list of strategies, and what most of them have in common: a proof by bounds, which holds in
// every call configuration and may rest on every assumption that is not about a position.

#include "ir/prove/requirements/strategy.h"

#include "ir/worlds/under_assumptions.h"

#include <array>
#include <utility>

namespace glider::ir::prove {

bool Strategy::proves(const Requirement&, StrategyContext&) const {
  return false;
}

std::optional<RequirementVerdict> Strategy::judge(Attempt& attempt,
                                                  StrategyContext& context) const {
  return proves(attempt.requirement, context)
             ? std::optional(RequirementVerdict{attempt.number, Verdict::Proved, std::nullopt})
             : std::nullopt;
}

RepeatedProof Strategy::provesAgain(const RequirementVerdict& was, StrategyContext& context) const {
  const Requirement& requirement = context.mission.requirements[was.requirement];
  return proves(requirement, context) ? provedAgain(requirement, context) : RepeatedProof();
}

RepeatedProof Strategy::provedAgain(const Requirement& requirement,
                                    StrategyContext& context) const {
  return {true, context.wantsEvidence() ? evidence(requirement, /*learnt=*/false, context)
                                        : std::nullopt};
}

RepeatedProof Strategy::againBy(std::optional<RequirementVerdict> verdict) {
  const bool proved = verdict && verdict->verdict == Verdict::Proved;
  return proved ? RepeatedProof{true, std::move(verdict->evidence)} : RepeatedProof();
}

std::optional<Evidence> Strategy::evidence(const Requirement& requirement, bool learnt,
                                           StrategyContext& context) const {
  return context.evidences().bound(requirement, learnt);
}

bool Strategy::mayRestOn(const Assumption& assumption, const Requirement& requirement) const {
  switch (assumption.kind) {
    case AssumptionKind::StartDepth:
    case AssumptionKind::Outage:
    case AssumptionKind::Range:
      return true;
    case AssumptionKind::StartInside:
    case AssumptionKind::Current:
      return false;
    case AssumptionKind::Always:
      return restsOnWatches(requirement);
  }
  return true;
}

std::span<const StrategyRow> strategies() {
  static const std::array kRows{
#define STRATEGY(name, phase, purpose) StrategyRow{strategy::name(), Phase::phase},
#include "ir/prove/requirements/strategies.def"
#undef STRATEGY
  };
  return kRows;
}

}  // namespace glider::ir::prove
