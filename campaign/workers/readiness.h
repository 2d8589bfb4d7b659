// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_plan.h"
#include "campaign/workers/ranks.h"

#include <string>
#include <vector>

namespace glider::campaign {

/// Whether a rank can fly a campaign, and which.
struct Readiness {
  size_t rank = 0;
  std::string host = {};
  int status = 0;             ///< other than 0: it cannot fly, and this is its exit code
  std::string reported = {};  ///< then: the messages that say why
  std::string identity = {};  ///< identityOf
  std::string boards = {};    ///< whose binaries fly
  /// The missions' flights without faults, to the last bit: processors and C libraries may differ.
  std::string measured = {};
};
/// That of a rank that can fly. The plan must be measured.
Readiness readinessOf(const CampaignPlan& plan, const std::string& identity);
/// That of a rank that cannot.
Readiness unreadiness(int status, const std::string& reported);

/// Reports it to rank 0.
void sendReadiness(Ranks& ranks, const Readiness& readiness);
/// On rank 0: waits until all other ranks have reported; returns what they did.
std::vector<Readiness> awaitReadiness(Ranks& ranks);
/// GL9389 if one of the others, which all can fly, would fly another campaign than `own`.
support::Result<void> requireSame(const Readiness& own, const std::vector<Readiness>& others);

}  // namespace glider::campaign
