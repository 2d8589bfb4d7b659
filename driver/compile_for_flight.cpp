// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/compile_for_flight.h"

#include "driver/exit_code.h"
#include "driver/terminal.h"
#include "ir/opt/optimise.h"

namespace glider::driver {

std::unique_ptr<compiler::Compilation> compileForFlight(const std::string& mission, int& status) {
  auto compiled = compiler::compileMission(mission);
  if (!compiled) {
    status = reportFailure(compiled.error());
    return nullptr;
  }
  reportDiagnostics((*compiled)->diagnostics, (*compiled)->sources);
  status = (*compiled)->ok() ? kFine : kMissionHasErrors;
  if (status != kFine) {
    return nullptr;
  }
  ir::optimise(*(*compiled)->mission);  // as `build` does: the flight's states have those numbers
  return std::move(*compiled);
}

}  // namespace glider::driver
