// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign_boards.h"
#include "campaign/campaign_csv.h"
#include "campaign/campaign_options.h"
#include "campaign/campaign_table.h"
#include "campaign/faults_toml.h"
#include "campaign/fly_all.h"

/// Thousands of flights under faults. A CampaignPlan says what flies: number by number (flightOf),
/// and with which faults (faultsOf), so that any flight can be flown alone (flyOne). flyAll flies
/// all of them on several threads and hands on each verdict; the table, the lines of violations and
/// the CSV, from which a campaign can be resumed, are made from those. Nothing here prints; others
/// include this header and no other of the folder.
