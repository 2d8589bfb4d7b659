// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign.h"
#include "driver/json_document.h"

namespace glider::driver {

/// One flight of a campaign, with what it needs to be flown again.
Json flightOf(const campaign::CampaignPlan& plan, const campaign::CampaignFlight& flight,
              const simulator::Verdict& verdict);

/// Adds the members of a whole campaign: numbers of flights by fault and outcome, requirements, and
/// all violations.
void putResult(Json& document, const campaign::CampaignPlan& plan,
               const campaign::CampaignResult& result);

}  // namespace glider::driver
