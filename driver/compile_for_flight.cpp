// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/compile_for_flight.h"

#include "driver/exit_code.h"
#include "driver/slocum/port_folder.h"
#include "driver/terminal.h"

#include <algorithm>

namespace glider::driver {

bool hasWarnings(const support::DiagnosticEngine& diagnostics) {
  const auto all = diagnostics.sorted();
  return std::ranges::count(all, support::Severity::Warning, &support::Diagnostic::severity) > 0;
}

std::shared_ptr<const compiler::Optimised> compileForFlight(const std::string& mission, int& status,
                                                            bool strict) {
  const auto folder = portFolderAt(mission);
  if (!folder) {
    status = reportFailure(folder.error());
    return nullptr;
  }
  const auto compiled =
      compiler::compileMission(*folder ? (*folder)->mission : std::filesystem::path(mission));
  if (!compiled) {
    status = reportFailure(compiled.error());
    return nullptr;
  }
  reportDiagnostics(compiled->diagnostics, *compiled->sources);
  const bool refused = strict && hasWarnings(compiled->diagnostics);
  status = compiled->checked && !refused ? kFine : kMissionHasErrors;
  return status == kFine
             ? std::make_shared<const compiler::Optimised>(compiler::optimise(compiled->checked))
             : nullptr;
}

}  // namespace glider::driver
