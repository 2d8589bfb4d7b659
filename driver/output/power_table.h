// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/board.h"
#include "platforms/load/platform.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace glider::driver {

/// The pack of a vehicle and what draws from it, as lines; "" for one that the simulator cannot
/// fly. `board`: the SBC that is usually on it, if its power is known.
std::string powerText(const platforms::Platform& platform,
                      const std::optional<platforms::Board>& board);
/// The same as a JSON object; null for such a vehicle.
nlohmann::ordered_json powerJson(const platforms::Platform& platform,
                                 const std::optional<platforms::Board>& board);

}  // namespace glider::driver
