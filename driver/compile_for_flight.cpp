// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/compile_for_flight.h"

#include "driver/exit_code.h"
#include "driver/terminal.h"

namespace glider::driver {

std::shared_ptr<const compiler::Optimised> compileForFlight(const std::string& mission,
                                                            int& status) {
  const auto compiled = compiler::compileMission(mission);
  if (!compiled) {
    status = reportFailure(compiled.error());
    return nullptr;
  }
  reportDiagnostics(compiled->diagnostics, *compiled->sources);
  status = compiled->checked ? kFine : kMissionHasErrors;
  return compiled->checked
             ? std::make_shared<const compiler::Optimised>(compiler::optimise(compiled->checked))
             : nullptr;
}

}  // namespace glider::driver
