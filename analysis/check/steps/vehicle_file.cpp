// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "simulator/slocum/own_mission.h"
#include "slocum/mission_files/load.h"

#include <utility>

namespace glider::analysis::check {

/// Reads the vehicle's mission file, if the options name one, or a scenario that has one.
support::Result<void> vehicleFile(Run& run) {
  std::optional<VehicleFile> file = run.options.vehicle;
  if (!file && !run.options.scenario.empty() && run.scenario->own.has_value()) {
    auto its = vehicleFileOf(simulator::missionFileOf(*run.scenario),
                             run.scenario->skeleton_path.string());
    if (!its) {
      return std::unexpected(its.error());
    }
    file = std::move(*its);
  }
  if (!file) {
    return {};
  }
  support::DiagnosticEngine diagnostics;  // shown when it was read first
  auto behaviours = slocum::loadMission(file->path, *run.file.compilation->sources, diagnostics,
                                        [](auto&&...) {});
  if (!behaviours) {
    return std::unexpected(behaviours.error());
  }
  run.vehicle = {std::move(*file), std::move(*behaviours)};
  return {};
}

}  // namespace glider::analysis::check
