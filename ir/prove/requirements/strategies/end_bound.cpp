// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy.h"

namespace glider::ir::prove {
namespace {

/// `exit within T`: the clocks end the mission by then (P7).
class EndByClocks final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return requirement.kind == RequirementKind::ExitWithin;
  }

  bool proves(const Requirement& requirement, StrategyContext& context) const override {
    return context.proof.ending.by(requirement.seconds).has_value();
  }
};

}  // namespace

const Strategy& strategy::endBound() {
  static const EndByClocks kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
