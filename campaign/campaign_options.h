// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_plan.h"
#include "flights/launch_choice.h"
#include "support/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::campaign {

/// A share of a campaign's flights.
struct CampaignPart {
  uint64_t number = 1, of = 1;
};

struct CampaignOptions {
  std::vector<std::string> missions;
  std::string scenario = "default";
  std::optional<double> duration_s;  ///< of the scenario; empty: as it says
  uint64_t flights = 1000;
  uint64_t seed = 1;
  unsigned jobs = 0;
  unsigned board_percent = 10;
  std::vector<std::string> faults;  ///< names of kinds; empty: all
  bool strict = false;              ///< missions with warnings are not flown
  std::string csv;
  std::vector<std::string> resume;
  CampaignPart part;
  std::optional<uint64_t> only;
  std::string output;
  flights::LaunchChoice launch;
  std::vector<std::string> user_code;
};

/// A digest of what a campaign's flights depend on: the program, the missions, their platforms, the
/// scenario and the options. GL9001.
support::Result<std::string> identityOf(const CampaignPlan& plan, const CampaignOptions& options);
/// `text` as one word for a shell.
std::string shellWord(const std::string& text);
/// The command that flies one of the flights, without the number of the flight.
std::string commandOf(const CampaignOptions& options);

}  // namespace glider::campaign
