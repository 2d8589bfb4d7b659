// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign.h"

namespace glider::campaign::testing {

/// Two missions, `one.mission` and `two.mission`, in the scenario `default`, with nothing wrong.
/// The pilot of both is the simulator tests' own and releases control after ten minutes.
CampaignPlan smallPlan(uint64_t flights);
/// Ignores everything and never stops.
CampaignListener deaf();
/// A verdict that no flight of it has: `number` is in its figures.
simulator::Verdict known(double number);

}  // namespace glider::campaign::testing
