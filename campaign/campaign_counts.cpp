// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign_counts.h"

#include <algorithm>

namespace glider::campaign {

std::vector<RequirementCount> requirementCounts(const CampaignPlan& plan,
                                                const CampaignResult& result) {
  std::vector<RequirementCount> counts;
  std::vector<size_t> first_of;  // where the counts of each mission begin
  for (size_t mission = 0; mission < plan.missions.size(); ++mission) {
    first_of.push_back(counts.size());
    for (size_t i = 0; i < plan.missions[mission].requirements.size(); ++i) {
      counts.push_back({mission, i, 0, 0, {}});
    }
  }
  eachFlown(plan, result, [&](const CampaignFlight& flight, const simulator::Verdict& verdict) {
    if (flight.board) {
      return;
    }
    const size_t begin = first_of[flight.mission];
    for (size_t i = 0; i < plan.missions[flight.mission].requirements.size(); ++i) {
      RequirementCount& count = counts[begin + i];
      ++count.flights;
      if (std::ranges::find(verdict.requirements, i) != verdict.requirements.end()) {
        ++count.violated;
        count.first = count.first.value_or(flight.number);
      }
    }
  });
  return counts;
}

}  // namespace glider::campaign
