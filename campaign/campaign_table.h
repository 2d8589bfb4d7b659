// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_result.h"

#include <string>

namespace glider::campaign {

/// "exited", "exited after release", "released", "VIOLATION".
const char* outcomeName(const simulator::Verdict& verdict);
/// Kinds of faults by outcomes, in numbers of flights, with the deepest of each; then when the
/// faults came, and what flew. Flights that were not flown are left out.
std::string campaignTable(const CampaignPlan& plan, const CampaignResult& result);
/// For each requirement of a mission that flies in this process: how many of its flights violate
/// it. Empty if there is none.
std::string requirementLines(const CampaignPlan& plan, const CampaignResult& result);
/// A line for each of the first violations, with the command that flies it again: `command` and its
/// number.
std::string violationLines(const CampaignPlan& plan, const CampaignResult& result,
                           const std::string& command);

}  // namespace glider::campaign
