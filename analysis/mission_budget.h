// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/budget.h"
#include "compiler/compilation.h"
#include "platforms/load/board.h"
#include "report/findings/findings.h"

#include <functional>
#include <string>
#include <vector>

namespace glider::analysis {

/// Upper bounds of what a mission needs: of the lines to the vehicle, then of each of `targets`,
/// with `user_code` linked. Reports GL4013 and GL4014 where that is more than is available. If some
/// `extern` names of the mission are in none of those files, nothing is known for a target. Fails
/// if the mission cannot be built, with GL4001, or as loading `user_code` does.
support::Result<std::vector<report::Budget>> missionBudgets(
    const compiler::Optimised& mission, const std::vector<std::string>& targets,
    const std::vector<std::string>& user_code, support::DiagnosticEngine& diagnostics);

/// Refuses a program that needs more than `board` has, with GL4013: for
/// codegen::CodegenOptions::accepts.
std::function<support::Result<void>(const codegen::Budget&)> onlyWhatFits(
    const platforms::Board& board, const compiler::Optimised& mission);

/// The targets that can hold a mission in the vehicle: all except the host.
std::vector<std::string> boardsInTheVehicle();

}  // namespace glider::analysis
