// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_plan.h"
#include "support/result.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace glider::campaign {

struct CampaignResult {
  std::vector<std::optional<simulator::Verdict>> verdicts;  ///< by number; none: not flown
  std::optional<support::Failure> failure;  ///< an I/O or system error: the rest was not flown
  bool hung = false;                        ///< a flight did not end
  bool interrupted = false;                 ///< flights under way were abandoned
  bool running = false;     ///< a thread still runs: the program can only be ended by force
  bool left_ranks = false;  ///< another rank has not ended: all can only be ended by force
};

/// Receives the progress of a campaign. `over` and `progress` are called by the thread that called
/// flyAll, `stop` by any.
struct CampaignListener {
  /// A flight is over. A failure ends the campaign.
  std::function<support::Result<void>(const CampaignFlight&, const simulator::Verdict&)> over;
  /// A few times a second: how many flights of the plan's part are over.
  std::function<void(uint64_t)> progress;
  std::function<bool()> stop;  ///< true to end it now
};

}  // namespace glider::campaign
