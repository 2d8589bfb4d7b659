// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "support/result.h"

#include <filesystem>

namespace glider::platforms {

/// Reads and checks a platform file. GL9001 if it cannot be read, GL5001 (with line) if it is
/// invalid.
support::Result<Platform> loadPlatform(const std::filesystem::path& path);

}  // namespace glider::platforms
