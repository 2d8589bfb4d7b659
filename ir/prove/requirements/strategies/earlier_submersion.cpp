// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy.h"

#include <utility>

namespace glider::ir::prove {
namespace {

/// The trace without power cuts that violated another `surfaces every`, as far as it violates this
/// one.
class EarlierSubmersion final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement& requirement) const override {
    return requirement.kind == RequirementKind::SurfacesEvery;
  }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    if (!context.submerged) {
      return std::nullopt;
    }
    auto run = concretize(*context.submerged, context.proof.proof_context,
                          context.proof.facts.stack_depth, attempt.requirement);
    return run ? std::optional(refutedBy(std::move(*run), attempt.requirement, context))
               : std::nullopt;
  }
};

}  // namespace

const Strategy& strategy::earlierSubmersion() {
  static const EarlierSubmersion kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
