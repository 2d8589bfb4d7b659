// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/entered_after.h"
#include "ir/prove/requirements/strategy.h"

namespace glider::ir::prove {
namespace {

/// `never S after T`: no chain of transitions leads there, for any values of the guards.
class Transitions final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return requirement.kind == RequirementKind::NeverAfter;
  }

  bool proves(const Requirement& requirement, StrategyContext& context) const override {
    return !mayEnterAfter(context.mission, requirement.state, requirement.after);
  }

  [[nodiscard]] std::optional<Evidence> evidence(const Requirement& requirement, bool /*learnt*/,
                                                 StrategyContext& context) const override {
    return context.evidences().neverAfter(requirement);
  }
};

}  // namespace

const Strategy& strategy::transitions() {
  static const Transitions kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
