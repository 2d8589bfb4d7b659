// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "platforms/load/toml_reader.h"
#include "support/result.h"

#include <string>
#include <vector>

namespace glider::platforms {

/// Reads [[instrument]]; empty if `root` has none. The sensors of `platform` are there. GL5001.
support::Result<std::vector<Instrument>> readInstruments(const std::string& file,
                                                         const toml::table& root,
                                                         const Platform& platform);

}  // namespace glider::platforms
