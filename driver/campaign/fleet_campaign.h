// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign.h"
#include "driver/json_document.h"

namespace glider::driver {

/// The campaign of a fleet file, the only mission of `options`: its vehicles fly together, with
/// trouble in what they send each other. Prints the result and returns the exit code; `document`
/// (null: text) gets it instead.
int campaignOfFleet(const campaign::CampaignOptions& options, unsigned jobs, Json* document);

}  // namespace glider::driver
