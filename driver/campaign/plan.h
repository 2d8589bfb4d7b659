// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign.h"

namespace glider::driver {

/// Makes the plan of the campaign: compiles and loads its missions and measures them. `jobs`
/// flights fly at a time. Returns kFine, or the exit code after it has reported why there is none.
int makePlan(const campaign::CampaignOptions& options, unsigned jobs, campaign::CampaignPlan& plan);

}  // namespace glider::driver
