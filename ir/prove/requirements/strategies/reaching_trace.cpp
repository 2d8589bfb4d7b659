// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy.h"
#include "ir/prove/requirements/trace_search.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <utility>

namespace glider::ir::prove {
namespace {

/// `reach S`: a trace that enters S, if possible without power cuts, which is easier to understand;
/// or the proof that none does.
class ReachingTrace final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return requirement.kind == RequirementKind::Reach;
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    TraceSearch found =
        searchTraces(attempt.requirement, context.insightWithoutPowerCuts(), context);
    if (!found.run && context.powerCutsMatter()) {
      found = searchTraces(attempt.requirement, context.insight(), context);
    }
    if (found.answer.bad == Answer::No) {
      return unreached(attempt, context);
    }
    if (found.run) {
      return RequirementVerdict{attempt.number, Verdict::Proved, std::move(found.run)};
    }
    attempt.reason = whyUndecided(attempt.requirement, found.answer, context);
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Evidence> evidence(const Requirement&, bool,
                                                 StrategyContext&) const override {
    return Evidence{Method::Run, {}};
  }

 private:
  static RequirementVerdict unreached(const Attempt& attempt, const StrategyContext& context) {
    const Mission& m = context.mission;
    context.proof.diagnostics.report(
        support::diagnostics::requirementBroken, attempt.requirement.range,
        fmt::format("no possible flight{} enters state `{}`",
                    m.assumptions.empty() ? "" : " that satisfies the assumptions",
                    m[attempt.requirement.state].name));
    return {attempt.number, Verdict::Refuted, std::nullopt};
  }
};

}  // namespace

const Strategy& strategy::reachingTrace() {
  static const ReachingTrace kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
