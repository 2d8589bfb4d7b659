// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"

#include <string>
#include <utility>

namespace glider::analysis::check {

/// What the vehicle's own mission does when the SBC has left control, and on what proofs rest with
/// it: that depends on all that was reported before.
support::Result<void> endings(Run& run) {
  if (!run.file.own_mission) {
    return {};
  }
  std::vector<std::string> lines =
      run.file.own_mission->checkEndings(run.worlds().widest, run.diagnostics());
  if (run.options.report) {
    for (std::string& line : lines) {
      run.remark(std::move(line));
    }
  }
  run.file.vehicle_premise =
      run.file.own_mission->premiseOf(run.worlds().widest, run.diagnostics());
  return {};
}

}  // namespace glider::analysis::check
