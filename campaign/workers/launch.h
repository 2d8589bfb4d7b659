// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "campaign/workers/ranks.h"
#include "support/result.h"

#include <cstddef>
#include <memory>

namespace glider::campaign {

/// This process among those that a launcher (mpirun, srun) started together, by its environment.
struct Launch {
  size_t rank = 0, size = 1;
};
Launch launchOf();

/// Joins the other ranks of `launch`; null if there are none. GL9388 if this installation has no
/// MPI, or another than the launcher's: each rank would fly the whole campaign.
support::Result<std::unique_ptr<Ranks>> joinRanks(const Launch& launch);

}  // namespace glider::campaign
