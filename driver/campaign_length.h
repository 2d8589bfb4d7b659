// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign.h"
#include "support/result.h"

namespace glider::driver {

/// Checks that each mission of a measured plan ends within the scenario if nothing fails: otherwise
/// every flight would count as a violation. GL9387.
support::Result<void> requireEnds(const campaign::CampaignPlan& plan, const std::string& scenario);

}  // namespace glider::driver
