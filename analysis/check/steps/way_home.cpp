// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/way_home.h"

#include "analysis/check/run.h"
#include "analysis/refused_commands.h"
#include "analysis/vehicle_limits.h"

#include <string>
#include <utility>

namespace glider::analysis::check {

using Subject = report::Remark::Subject;

/// How the vehicle comes up without the SBC and, if no mission file of the vehicle says it better,
/// which commands hookbeh would refuse.
support::Result<void> wayHome(Run& run) {
  const auto& vehicle = run.vehicle;
  if (auto line = vehicle ? endlessLine(run.checked(), vehicle->file) : std::nullopt) {
    run.remark(std::move(*line), Subject::End);
  }
  const Silence silence = vehicle ? vehicle->file.silence : usualSilence();
  for (std::string& line : wayHomeLines(run.mission(), run.platform(), silence)) {
    run.remark(std::move(line), Subject::WayHome);
  }
  if (!vehicle) {
    for (std::string& line : refusedLines(run.mission(), usualLimits())) {
      run.remark(std::move(line));
    }
  }
  return {};
}

}  // namespace glider::analysis::check
