// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_result.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace glider::campaign {

/// Calls `visit` with each flight that was flown, and its verdict, by number; of a plan of missions
/// or of a fleet.
template <typename Plan, typename Result, typename Visit>
void eachFlown(const Plan& plan, const Result& result, const Visit& visit) {
  for (uint64_t number = 0; number < result.verdicts.size(); ++number) {
    if (const auto& verdict = result.verdicts[number]) {
      visit(flightOf(plan, number), *verdict);
    }
  }
}

/// How the flights of a mission kept one of its requirements. The flights that count are those in
/// this process: a board's binary is not watched.
struct RequirementCount {
  size_t mission = 0;      ///< in CampaignPlan::missions
  size_t requirement = 0;  ///< in the mission's requirements
  uint64_t flights = 0;
  uint64_t violated = 0;
  std::optional<uint64_t> first;  ///< the first flight that violates it
};

/// One for each requirement of each mission, in their order.
std::vector<RequirementCount> requirementCounts(const CampaignPlan& plan,
                                                const CampaignResult& result);

}  // namespace glider::campaign
