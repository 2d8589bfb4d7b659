// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/vehicle_limits.h"

#include "analysis/check/run.h"

namespace glider::analysis::check {

/// Reports what the vehicle's mission file does not allow.
support::Result<void> vehicleLimits(Run& run) {
  if (run.vehicle) {
    checkVehicleLimits(run.checked(), run.vehicle->file, run.diagnostics());
  }
  return {};
}

}  // namespace glider::analysis::check
