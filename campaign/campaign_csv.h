// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/fly_all.h"

#include <string>

namespace glider::campaign {

/// The head of a campaign's table of flights: the campaign that it belongs to (`identity`, a
/// digest) and the names of its columns.
std::string csvHead(const std::string& identity);
/// The row of a flight.
std::string csvRow(const CampaignPlan& plan, const CampaignFlight& flight,
                   const simulator::Verdict& verdict);
/// The whole table, in the order of the flights' numbers.
std::string campaignCsv(const CampaignPlan& plan, const CampaignResult& result,
                        const std::string& identity);

/// Reads the flights of a table that csvHead and csvRow have written, for a campaign with the same
/// `identity`, into `result`. A last line without a line end is incomplete and is left out. GL9001;
/// GL9373 if it is not such a table.
support::Result<void> readCsv(const std::string& file, const CampaignPlan& plan,
                              const std::string& identity, CampaignResult& result);

}  // namespace glider::campaign
