// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy.h"
#include "ir/prove/requirements/trace_search.h"

namespace glider::ir::prove {
namespace {

/// Spacer over all traces once more, with other lemmas, if the first search was cut short: timers
/// and calls, of which times add up, are often proved so.
class OtherLemmas final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return isPromiseOfTraces(requirement);
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    return isCutShort(attempt.reason) ? search(attempt.requirement, context) : std::nullopt;
  }

  RepeatedProof provesAgain(const RequirementVerdict& was,
                            StrategyContext& context) const override {
    return againBy(search(context.mission.requirements[was.requirement], context));
  }

 private:
  static std::optional<RequirementVerdict> search(const Requirement& requirement,
                                                  StrategyContext& context) {
    return provedIf(provenByTraces(requirement, context.insight(), context, Lemmas::Elimination),
                    requirement, context);
  }
};

}  // namespace

const Strategy& strategy::otherLemmas() {
  static const OtherLemmas kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
