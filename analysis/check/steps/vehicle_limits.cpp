// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"

namespace glider::analysis::check {

support::Result<void> vehicleLimits(Run& run) {
  if (run.file.own_mission) {
    run.file.own_mission->checkLimits(run.worlds().written, run.diagnostics());
  }
  return {};
}

}  // namespace glider::analysis::check
