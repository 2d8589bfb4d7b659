// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "platforms/load/toml_reader.h"
#include "support/result.h"

#include <string>

namespace glider::platforms {

/// Reads [power] with its rows [[power.draw]], of a vehicle whose sensors and motion are known.
support::Result<Power> readPower(const std::string& file, const toml::table& root,
                                 const Platform& platform);

}  // namespace glider::platforms
