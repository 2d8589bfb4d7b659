// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/depth_bound.h"
#include "ir/prove/requirements/strategy.h"

namespace glider::ir::prove {
namespace {

/// `always depth <= d`: no command leads deeper than the condition allows (V3, V4).
class CommandedDepths final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return requirement.kind == RequirementKind::Always && requirement.geofences.empty();
  }

  bool proves(const Requirement& requirement, StrategyContext& context) const override {
    return heldByCommands(requirement.condition, context.proof.proof_context, context.deepest);
  }
};

}  // namespace

const Strategy& strategy::commandedDepths() {
  static const CommandedDepths kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
