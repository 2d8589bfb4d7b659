// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/requirements/strategy.h"

#include <utility>

namespace glider::ir::prove {
namespace {

/// The trace with power cuts that Spacer has found: neither it nor random flights have found one
/// without.
class TraceWithPowerCuts final : public Strategy {
 public:
  [[nodiscard]] bool serves(const Requirement&) const override { return true; }

  std::optional<RequirementVerdict> judge(Attempt& attempt,
                                          StrategyContext& context) const override {
    return attempt.with_power_cuts ? std::optional(refutedBy(std::move(*attempt.with_power_cuts),
                                                             attempt.requirement, context))
                                   : std::nullopt;
  }
};

}  // namespace

const Strategy& strategy::traceWithPowerCuts() {
  static const TraceWithPowerCuts kStrategy;
  return kStrategy;
}

}  // namespace glider::ir::prove
