// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace glider::support {

/// The whole content of `path`; GL9001 when it cannot be read (missing, a directory, over 64 MiB,
/// an I/O error).
Result<std::string> readFile(const std::filesystem::path& path);

/// Writes `content` to `path` so that a reader sees the old file or the new one, never a part: a
/// temporary file beside it, flushed, then renamed. GL9002 on failure, with nothing left behind.
/// `executable` sets mode 755.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                                 bool executable = false);

}  // namespace glider::support
