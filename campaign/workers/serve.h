// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_plan.h"
#include "campaign/workers/ranks.h"

#include <functional>

namespace glider::campaign {

/// What a rank other than 0 does once it has reported that it is ready: flies what rank 0 deals, on
/// `jobs` threads, until rank 0 ends the campaign. Flights under way are abandoned when `stop`
/// returns true, and rank 0 then ends the campaign. Returns true if a thread still runs: the
/// process can then only be ended by force.
bool serveRank(const CampaignPlan& plan, Ranks& ranks, const std::function<bool()>& stop);
/// What a rank does that cannot fly: waits until rank 0 ends the campaign.
void awaitEnd(Ranks& ranks);

/// On rank 0: ends a campaign that has not begun. False if a rank does not answer: all can then
/// only be ended by force.
bool dismissRanks(Ranks& ranks);

}  // namespace glider::campaign
