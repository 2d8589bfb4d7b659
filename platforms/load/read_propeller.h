// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/propeller_motion.h"
#include "platforms/load/toml_reader.h"
#include "support/result.h"

#include <string>
#include <string_view>

namespace glider::platforms {

/// The keys of [power] that only a vehicle with a propeller has.
inline constexpr std::string_view kPowerRpm = "propeller_rpm", kPowerWatt = "propeller_W";

/// Reads [motion] of the model "propeller" with its tables. GL5001.
support::Result<PropellerMotion> readPropellerMotion(const std::string& file,
                                                     const toml::table& root);

/// Reads those two keys of [power]; the table must reach to `greatest_rpm`.
PropellerPower readPropellerPower(TomlReader& power, double greatest_rpm);

}  // namespace glider::platforms
