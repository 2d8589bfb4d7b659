// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/random_trials.h"
#include "ir/prove/requirements/strategy.h"
#include "ir/prove/requirements/trace_search.h"

#include <utility>

namespace glider::ir::prove {
namespace {

/// Spacer over all traces, for an SBC whose power may be cut. A counterexample without power cuts
/// is preferred to what it finds.
class AllTraces final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return isPromiseOfTraces(requirement);
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    TraceSearch found = searchTraces(attempt.requirement, context.insight(), context);
    if (found.answer.bad == Answer::No) {
      return provedBy(std::move(found.answer), attempt.requirement, context);
    }
    if (!found.run) {
      attempt.reason = whyUndecided(attempt.requirement, found.answer, context);
    } else if (context.powerCutsMatter()) {
      attempt.with_power_cuts = std::move(found.run);
    } else {
      keepSubmersion(attempt.requirement, found, context);
      return refutedBy(simplest(*std::move(found.run), attempt.requirement,
                                context.proof.proof_context, context),
                       attempt.requirement, context);
    }
    return std::nullopt;
  }

  /// What took no search the first time is not searched for.
  RepeatedProof provesAgain(const RequirementVerdict& was,
                            StrategyContext& context) const override {
    if (!was.searched) {
      return {};
    }
    const Requirement& requirement = context.mission.requirements[was.requirement];
    RunsAnswer answer = provenByTraces(requirement, context.insight(), context);
    if (answer.bad != Answer::No) {
      return {};
    }
    return {true, provedBy(std::move(answer), requirement, context).evidence};
  }
};

}  // namespace

const Strategy& strategy::allTraces() {
  static const AllTraces kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
