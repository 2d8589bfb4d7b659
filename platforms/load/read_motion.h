// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "platforms/load/toml_reader.h"
#include "support/result.h"

#include <string>

namespace glider::platforms {

/// The model of vehicles with a propeller: `model` of [motion].
inline constexpr std::string_view kPropellerModel = "propeller";

/// Whether [motion] of `root` names that model.
bool isPropelled(const toml::table& root);

/// Reads [motion] with the tables of its model, and [power], into `platform`, whose envelope has
/// been read. Without [motion] it leaves both empty. GL5001.
support::Result<void> readMotionAndPower(const std::string& file, const toml::table& root,
                                         Platform& platform);

}  // namespace glider::platforms
