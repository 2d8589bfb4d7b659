// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/campaign_length.h"

#include "ir/prove/abstract/end_bound.h"
#include "ir/prove/context/duration_text.h"
#include "support/diagnostics/catalogue.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace glider::driver {
namespace {

using ir::prove::durationOf;

/// The longest time that the mission may last without power cuts, s; none: not known.
std::optional<double> longestOf(const campaign::CampaignMission& mission) {
  if (mission.compiled == nullptr) {
    return std::nullopt;
  }
  const ir::prove::ProofContext context(mission.compiled->checked->mission(), mission.platform);
  return ir::prove::boundOf(context.withoutPowerCuts(), ir::prove::kLongestMission,
                            ir::prove::Goal::Exit)
      .by;
}

}  // namespace

support::Result<void> requireEnds(const campaign::CampaignPlan& plan, const std::string& scenario) {
  for (const campaign::CampaignMission& mission : plan.missions) {
    const bool ends = mission.times.take_s <= 0 || mission.times.release_s > 0;
    if (ends) {
      continue;
    }
    const auto longest = longestOf(mission);
    return support::fail(
        support::DiagnosticId::scenarioTooShort, mission.file, durationOf(plan.scenario.duration_s),
        scenario, longest ? fmt::format(": it may last {}", durationOf(*longest)) : "",
        longest
            ? fmt::format("copy the scenario, and set `duration_s` in the copy to at least {:.0f}",
                          std::ceil(*longest))
            : "copy the scenario, and set `duration_s` in the copy to longer than the mission "
              "lasts; if it never ends, add a case with `exit`");
  }
  return {};
}

}  // namespace glider::driver
