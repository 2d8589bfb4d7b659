// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

namespace glider::ir::prove {
namespace {

/// `stack <= n`, against the exact call depth of ir/verify (L1 to L4): it is proved or refuted.
class CallDepth final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return requirement.kind == RequirementKind::StackAtMost;
  }

  bool proves(const Requirement& requirement, StrategyContext& context) const override {
    return context.proof.facts.stack_depth <= requirement.depth;
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    if (proves(attempt.requirement, context)) {
      return RequirementVerdict{attempt.number, Verdict::Proved, std::nullopt};
    }
    const std::string words = tooDeep(context);
    if (!context.mission.assumptions.empty()) {  // which may exclude these calls
      RequirementVerdict open;
      open.reason = words + "; what the mission assumes is not considered here";
      return open;
    }
    context.proof.diagnostics.report(support::diagnostics::requirementBroken,
                                     attempt.requirement.range, words);
    return RequirementVerdict{attempt.number, Verdict::Refuted, std::nullopt};
  }

  [[nodiscard]] std::optional<Evidence> evidence(const Requirement& requirement, bool /*learnt*/,
                                                 StrategyContext& context) const override {
    return context.evidences().callDepth(requirement);
  }

 private:
  static std::string tooDeep(const StrategyContext& context) {
    const MissionFacts& facts = context.proof.facts;
    std::string path;
    for (const StateId state : facts.deepest_path) {
      path += fmt::format("{}`{}`", path.empty() ? "" : " calls ", context.mission[state].name);
    }
    return fmt::format("up to {} state{} may wait on the call stack: {}", facts.stack_depth,
                       facts.stack_depth == 1 ? "" : "s", path);
  }
};

}  // namespace

const Strategy& strategy::callDepth() {
  static const CallDepth kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
