// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/compilation.h"
#include "driver/launch_choice.h"
#include "driver/sbc_choice.h"

#include <memory>
#include <string>
#include <vector>

namespace glider::driver {

/// The targets that are boards and whose emulator is here; `missing` gets a sentence for each of
/// the others.
std::vector<std::string> boardsHere(std::vector<std::string>& missing);

/// Flights of the mission's binary for `board`, each with a storage card of its own in a temporary
/// folder. The binary is built when the first one starts.
NewFlight flightsOnBoard(std::shared_ptr<const Compilation> compilation, const LaunchChoice& launch,
                         const std::vector<std::string>& user_code, const std::string& board);

}  // namespace glider::driver
