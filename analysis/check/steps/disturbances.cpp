// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"

namespace glider::analysis::check {

/// Reports what in the vehicle's own mission keeps the SBC from flying this one.
support::Result<void> disturbances(Run& run) {
  if (run.file.own_mission) {
    run.file.own_mission->checkDisturbances(run.worlds(), run.diagnostics());
  }
  return {};
}

}  // namespace glider::analysis::check
