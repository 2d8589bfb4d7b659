// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace glider::campaign {

/// The head of a campaign's table of flights: the campaign that it belongs to (`identity`, a
/// digest) and the names of its columns.
std::string csvHead(const std::string& identity);
/// The row of a flight.
std::string csvRow(const CampaignPlan& plan, const CampaignFlight& flight,
                   const simulator::Verdict& verdict);
/// Reads a row without its line end; false for a line that is not the row of a flight of `plan`.
bool parseRow(const CampaignPlan& plan, std::string_view line, uint64_t& number,
              simulator::Verdict& verdict);
/// The whole table, in the order of the flights' numbers.
std::string campaignCsv(const CampaignPlan& plan, const CampaignResult& result,
                        const std::string& identity);

/// Reads the flights of a table that csvHead and csvRow have written, for a campaign with the same
/// `identity`, into `result`, beside those that are there. A last line without a line end is
/// incomplete and is left out. GL9001; GL9373 if it is not such a table, or if a flight has another
/// outcome in `result`.
support::Result<void> readCsv(const std::string& file, const CampaignPlan& plan,
                              const std::string& identity, CampaignResult& result);

}  // namespace glider::campaign
