// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy.h"
#include "ir/prove/requirements/trace_search.h"
#include "ir/worlds/under_assumptions.h"

#include <utility>

namespace glider::ir::prove {
namespace {

/// Spacer over all traces of the mission without its assumptions: their monitors make a search
/// longer, so it may succeed without them.
class WithoutAssumptions final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return restsOnWatches(requirement);
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    StrategyContext* bare = context.bare;
    if (bare == nullptr || context.proof.searches.isUsedUp()) {
      return std::nullopt;
    }
    const Requirement& requirement = bare->mission.requirements[attempt.number];
    TraceSearch found = searchTraces(requirement, bare->insight(), *bare);
    std::optional<RequirementVerdict> verdict;
    if (found.answer.bad == Answer::No) {
      verdict = provedBy(std::move(found.answer), requirement, *bare);
    } else if (const Strategy& named = strategy::namedStates(); named.serves(requirement)) {
      Attempt again{attempt.number, requirement};
      verdict = named.judge(again, *bare);
    }
    if (!verdict) {
      RunsAnswer answer = provenByTraces(requirement, bare->insight(), *bare, Lemmas::Elimination);
      verdict = answer.bad == Answer::No
                    ? std::optional(provedBy(std::move(answer), requirement, *bare))
                    : std::nullopt;
    }
    if (verdict) {
      verdict->searched = true;
    }
    return verdict;
  }

  [[nodiscard]] bool mayRestOn(const Assumption&, const Requirement&) const override {
    return false;
  }
};

}  // namespace

const Strategy& strategy::withoutAssumptions() {
  static const WithoutAssumptions kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
