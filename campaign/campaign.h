// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_boards.h"
#include "campaign/campaign_counts.h"
#include "campaign/campaign_csv.h"
#include "campaign/campaign_options.h"
#include "campaign/campaign_plan.h"
#include "campaign/campaign_result.h"
#include "campaign/campaign_table.h"
#include "campaign/faults_toml.h"
#include "campaign/fleet/fleet_plan.h"
#include "campaign/fleet/fleet_table.h"
#include "campaign/fleet/fleet_trouble.h"
#include "campaign/fleet/fly_fleets.h"
#include "campaign/workers/fly_all.h"
#include "campaign/workers/launch.h"
#include "campaign/workers/readiness.h"
#include "campaign/workers/serve.h"

/// Thousands of flights with faults. A CampaignPlan defines each flight by its number (flightOf)
/// and its faults (faultsOf), so that any flight can be flown alone (flyOne). flyAll flies all of
/// them on several threads, and on other processes (Ranks) if mpirun started them, and passes on
/// each verdict. The table, the lines of violations and the CSV, from which a campaign can be
/// resumed, are made from the verdicts. Nothing here prints. Other folders include only this
/// header.
