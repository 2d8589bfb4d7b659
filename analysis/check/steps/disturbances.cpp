// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "analysis/vehicle_guards.h"
#include "analysis/whole/control.h"
#include "analysis/whole/hookbeh_needs.h"
#include "support/diagnostics/catalogue.h"

#include <algorithm>

namespace glider::analysis::check {

using support::DiagnosticId;

/// Reports what in the vehicle's mission file keeps hookbeh from flying the mission.
support::Result<void> disturbances(Run& run) {
  if (!run.vehicle) {
    return {};
  }
  const VehicleUnderCheck& vehicle = *run.vehicle;
  const platforms::Platform platform = run.platform();
  const auto layers = layersOf(vehicle.behaviours, platform);
  checkGuards(run.checked(), vehicle.file, layers, run.diagnostics());
  checkSameDepth(run.checked(), vehicle.file, run.diagnostics());
  const MissionTimes times(run.mission(), platform, std::max(0.0, vehicle.file.guards.start_secs));
  for (const Disturbance& one :
       analysis::disturbances(vehicle.behaviours, layers, times, platform)) {
    const bool masks = one.kind == Disturbance::Kind::Masks;
    run.diagnostics().report(masks ? DiagnosticId::commandsMasked : DiagnosticId::controlPrevented,
                             one.range, one.what, one.change);
  }
  for (const Doubt& one : unmetNeeds(vehicle.behaviours)) {
    run.diagnostics().report(DiagnosticId::sensorUnread, one.range, one.why, one.change);
  }
  return {};
}

}  // namespace glider::analysis::check
