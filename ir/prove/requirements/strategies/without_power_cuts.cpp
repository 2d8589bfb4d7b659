// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/random_trials.h"
#include "ir/prove/requirements/strategy.h"
#include "ir/prove/requirements/trace_search.h"

#include <utility>

namespace glider::ir::prove {
namespace {

/// The same without power cuts: a counterexample is easier to understand, and a proof is worth a
/// word if there is none with power cuts.
class WithoutPowerCuts final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return isPromiseOfTraces(requirement);
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    if (!context.powerCutsMatter()) {
      return std::nullopt;
    }
    Insight& insight = context.insightWithoutPowerCuts();
    TraceSearch found;
    if (!insight.proves(attempt.requirement, context.proof.options.effort,
                        context.proof.searches)) {
      found = searchTraces(attempt.requirement, insight, context);
      keepSubmersion(attempt.requirement, found, context);
      if (found.run) {
        const ProofContext powered = context.proof.proof_context.withoutPowerCuts();
        return refutedBy(simplest(*std::move(found.run), attempt.requirement, powered, context),
                         attempt.requirement, context);
      }
      if (found.answer.bad != Answer::No) {
        return std::nullopt;
      }
    }
    attempt.holds_without_power_cuts = true;
    attempt.reason += "; it holds if the SBC never loses power";
    return std::nullopt;
  }
};

}  // namespace

const Strategy& strategy::withoutPowerCuts() {
  static const WithoutPowerCuts kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
