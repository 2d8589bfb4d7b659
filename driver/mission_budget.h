// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/compilation.h"
#include "report/findings/findings.h"

#include <string>
#include <vector>

namespace glider::driver {

/// What a mission that is ok() needs at most of the lines to the vehicle, then of each of
/// `targets`. Reports GL4013 and GL4014 where that is more than there is. A failure of the world is
/// that of building it, GL4001.
support::Result<std::vector<report::Budget>> missionBudgets(
    Compilation& compilation, const std::vector<std::string>& targets);

/// The targets that hold a mission in the vehicle: all but the one that is this machine.
std::vector<std::string> boardsInTheVehicle();

}  // namespace glider::driver
