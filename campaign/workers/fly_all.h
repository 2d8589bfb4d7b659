// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_result.h"
#include "campaign/workers/ranks.h"

namespace glider::campaign {

/// Flies all flights of the plan's part that have no verdict in `known`: on `jobs` threads of this
/// process, and on the other ranks if there are any (this is then rank 0, and the others must be in
/// serveRank). A flight that takes longer than the plan allows hangs: its verdict reports that, and
/// the rest of the campaign is not flown. Which process flies a flight does not change its verdict.
CampaignResult flyAll(const CampaignPlan& plan, CampaignResult known,
                      const CampaignListener& listener, Ranks* ranks = nullptr);

}  // namespace glider::campaign
