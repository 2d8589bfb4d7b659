// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "analysis/mission_budget.h"

#include <utility>

namespace glider::analysis::check {

/// What the mission needs of each board.
support::Result<void> budgets(Run& run) {
  run.observer.at("compiling it for the boards");
  auto found = missionBudgets(
      run.optimised(), run.options.targets.empty() ? boardsInTheVehicle() : run.options.targets,
      run.options.user_code, run.diagnostics());
  if (!found) {
    return std::unexpected(found.error());
  }
  run.file.found.budgets = std::move(*found);
  return {};
}

}  // namespace glider::analysis::check
