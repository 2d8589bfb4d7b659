// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy.h"

namespace glider::ir::prove {
namespace {

/// What is known of any moment, of the end and of the longest submersion; more with each
/// requirement that is proved.
class KnownBounds final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    switch (requirement.kind) {
      case RequirementKind::Always:
        return requirement.geofences.empty();
      case RequirementKind::ExitWithin:
      case RequirementKind::SurfacesEvery:
        return true;
      case RequirementKind::NeverAfter:
      case RequirementKind::StackAtMost:
      case RequirementKind::Reach:
        break;
    }
    return false;
  }

  bool proves(const Requirement& requirement, StrategyContext& context) const override {
    return context.insight().proves(requirement, context.proof.options.effort,
                                    context.proof.searches);
  }
};

}  // namespace

const Strategy& strategy::insight() {
  static const KnownBounds kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
