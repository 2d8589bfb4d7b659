// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/launch_choice.h"
#include "flights/sbc_choice.h"

#include <memory>
#include <string>
#include <vector>

namespace glider::campaign {

/// The targets that are boards and whose emulator is installed; `missing` gets a sentence for each
/// of the others.
std::vector<std::string> boardsHere(std::vector<std::string>& missing);

/// Flights of the mission's binary for `board`, each with a storage card of its own in a temporary
/// folder. The binary is built when the first one starts.
flights::NewFlight flightsOnBoard(std::shared_ptr<const compiler::Optimised> mission,
                                  const flights::LaunchChoice& launch,
                                  const std::vector<std::string>& user_code,
                                  const std::string& board);

}  // namespace glider::campaign
