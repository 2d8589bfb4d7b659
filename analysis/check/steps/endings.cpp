// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "analysis/vehicle_premise.h"
#include "analysis/whole/whole.h"
#include "support/diagnostics/catalogue.h"

#include <string>
#include <utility>

namespace glider::analysis::check {

/// What the vehicle's own mission file does when the SBC has left control, and on what proofs rest
/// with it: that depends on all that was reported before.
support::Result<void> endings(Run& run) {
  if (!run.vehicle) {
    return {};
  }
  const Whole whole = wholeOf(run.mission(), run.platform(), run.vehicle->behaviours);
  for (const Ending& ending : whole.alike()) {
    if (!ending.proved()) {
      run.diagnostics().report(support::DiagnosticId::mayStayBelow, ending.range, ending.after,
                               ending.why_not, ending.change);
    }
  }
  if (run.options.report) {
    for (std::string& line : wholeLines(whole)) {
      run.remark(std::move(line));
    }
  }
  run.file.vehicle_premise = premiseWith(run.checked(), run.vehicle->file, run.diagnostics());
  return {};
}

}  // namespace glider::analysis::check
