// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/counters.h"
#include "ir/prove/requirements/strategy.h"
#include "ir/prove/requirements/trace_search.h"

#include <utility>

namespace glider::ir::prove {
namespace {

/// Spacer over the states and the counters alone: a promise without times, such as `visit S at most
/// 5 times`, needs no clock, and with a timer in `always` no search that follows the clocks ends.
class CountedPromises final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return isPromiseOfTraces(requirement) && requirement.kind == RequirementKind::Always &&
           requirement.monitor.step.valid() && requirement.monitor.horizon_s <= 0;
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    return attempt.with_power_cuts ? std::nullopt : search(attempt.number, context);
  }

  RepeatedProof provesAgain(const RequirementVerdict& was,
                            StrategyContext& context) const override {
    return againBy(search(was.requirement, context));
  }

  /// What the mission assumes is left out.
  [[nodiscard]] bool mayRestOn(const Assumption&, const Requirement&) const override {
    return false;
  }

 private:
  static std::optional<RequirementVerdict> search(uint32_t number, StrategyContext& assuming) {
    StrategyContext& context = assuming.bare != nullptr ? *assuming.bare : assuming;
    const std::optional<Mission> counters = onlyCounters(context.mission);
    if (!counters) {
      return std::nullopt;
    }
    const ProofContext proof_context(*counters, context.proof.proof_context.platform);
    const EndBound unknown;
    Insight insight(proof_context, unknown);
    // Small questions, in which Spacer counts as far as the mission does.
    const unsigned usual =
        std::exchange(context.search_effort, StrategyContext::kLonger * context.search_effort);
    RunsAnswer answer = provenByTraces(counters->requirements[number], insight, context);
    context.search_effort = usual;
    return provedIf(std::move(answer), context.mission.requirements[number], context);
  }
};

}  // namespace

const Strategy& strategy::counted() {
  static const CountedPromises kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
