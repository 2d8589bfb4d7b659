// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "report/findings/findings.h"

#include <string>
#include <vector>

namespace glider::analysis {

/// What a mission needs at most of the lines to the vehicle, then of each of `targets`, with
/// `user_code` linked. Reports GL4013 and GL4014 where that is more than there is.
/// Of a mission some of whose `extern` names are in none of those files nothing is known on a
/// target. A failure of the world is that of building it, GL4001, or of loading `user_code`.
support::Result<std::vector<report::Budget>> missionBudgets(
    const compiler::Optimised& mission, const std::vector<std::string>& targets,
    const std::vector<std::string>& user_code, support::DiagnosticEngine& diagnostics);

/// The targets that hold a mission in the vehicle: all but the one that is this machine.
std::vector<std::string> boardsInTheVehicle();

}  // namespace glider::analysis
