// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/modem.h"
#include "platforms/load/toml_reader.h"
#include "support/result.h"

#include <optional>
#include <string>

namespace glider::platforms {

/// Reads [modem]; empty if `root` has none. GL5001.
support::Result<std::optional<Modem>> readModem(const std::string& file, const toml::table& root);

}  // namespace glider::platforms
