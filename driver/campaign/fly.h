// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign.h"
#include "driver/json_document.h"

#include <string>

namespace glider::driver {

/// Flies the one flight that `--only` names and prints how it went, or puts it into `document`
/// (null: none); returns the exit code.
int flyOnly(const campaign::CampaignPlan& plan, const campaign::CampaignOptions& options,
            Json* document);

/// How a campaign went.
struct Flown {
  int status = 0;
  bool begun = false;       ///< false: the other ranks still wait
  bool running = false;     ///< a thread does not let the program end
  bool left_ranks = false;  ///< another rank does not end
};
/// Flies the campaign on this process and the other ranks, if any; writes its file and prints the
/// table, or puts it into `document` (null: none). `identity`: identityOf the plan.
Flown flyThem(const campaign::CampaignPlan& plan, const campaign::CampaignOptions& options,
              const std::string& identity, campaign::Ranks* ranks, Json* document);

}  // namespace glider::driver
