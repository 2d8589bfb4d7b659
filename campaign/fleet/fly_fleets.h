// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/fleet/fleet_plan.h"
#include "support/result.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace glider::campaign {

struct FleetCampaignResult {
  std::vector<std::optional<FleetVerdict>> verdicts;  ///< by number; none: not flown
  std::optional<support::Failure> failure;            ///< the rest was not flown
  bool interrupted = false;                           ///< flights under way were abandoned
};

/// Receives the progress. Both are called by the thread that called flyFleets, `stop` by any.
struct FleetCampaignListener {
  /// A few times a second: how many flights are over.
  std::function<void(uint64_t)> progress;
  std::function<bool()> stop;  ///< true to end it now
};

/// Flies all flights of the plan, on its threads. How many there are changes no verdict.
FleetCampaignResult flyFleets(const FleetCampaignPlan& plan, const FleetCampaignListener& listener);

}  // namespace glider::campaign
