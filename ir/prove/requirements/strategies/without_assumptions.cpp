// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy.h"
#include "ir/prove/requirements/trace_search.h"
#include "ir/worlds/under_assumptions.h"

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
    auto verdict =
        provedIf(searchTraces(requirement, bare->insight(), *bare).answer, requirement, *bare);
    const Strategy& named = strategy::namedStates();
    if (!verdict && named.serves(requirement)) {
      Attempt again{attempt.number, requirement};
      verdict = named.judge(again, *bare);
    }
    if (!verdict) {
      verdict = provedIf(provenByTraces(requirement, bare->insight(), *bare, Lemmas::Elimination),
                         requirement, *bare);
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
