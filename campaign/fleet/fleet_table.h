// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/fleet/fly_fleets.h"

#include <string>

namespace glider::campaign {

/// Kinds of trouble by outcomes, in numbers of flights, with the deepest of each, the least
/// distance, and the share of messages that were received. Flights that were not flown are left
/// out.
std::string fleetTable(const FleetCampaignPlan& plan, const FleetCampaignResult& result);
/// For each requirement and assumption of a vehicle: in how many of the flights it does not hold.
std::string fleetRequirementLines(const FleetCampaignPlan& plan, const FleetCampaignResult& result);
/// A line for each of the first violations, with the command that flies it again: `command` and its
/// number.
std::string fleetViolationLines(const FleetCampaignPlan& plan, const FleetCampaignResult& result,
                                const std::string& command);

}  // namespace glider::campaign
