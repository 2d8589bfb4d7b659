// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/campaign.h"

namespace glider::driver {

/// One rank of a campaign that mpirun or srun started as `launch`. Only rank 0 prints and writes
/// files; the exit code of the others is 0 unless MPI is missing. `jobs` flights fly at a time on
/// each rank.
int campaignOnRanks(const campaign::CampaignOptions& options, unsigned jobs,
                    const campaign::Launch& launch);

}  // namespace glider::driver
