// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/campaign.h"

#include <string>

namespace glider::driver {

/// Kinds of faults by outcomes, in numbers of flights.
std::string campaignTable(const CampaignPlan& plan, const CampaignResult& result);
/// A line for each of the first violations, and how to look at them.
std::string violationLines(const CampaignPlan& plan, const CampaignResult& result);
/// A row a flight.
std::string campaignCsv(const CampaignPlan& plan, const CampaignResult& result);
/// What went wrong in a flight, as the [faults] tables of a scenario file.
std::string faultsToToml(const simulator::Faults& faults);

}  // namespace glider::driver
