// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <filesystem>
#include <string_view>

namespace glider::driver {

/// Replaces a file's content with `text`, atomically; a link to the file stays a link, and its
/// permissions stay. GL9002 on failure, with the file unchanged.
support::Result<void> rewriteFile(const std::filesystem::path& path, std::string_view text);

}  // namespace glider::driver
