// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace glider::support {

/// The whole content of `path`; GL9001 when it cannot be read (missing, a directory, over 64 MiB,
/// an I/O error).
Result<std::string> readFile(const std::filesystem::path& path);

/// What is written, and so how: a product can be made again, so it does not wait for the disk, and
/// a power cut may lose it.
enum class FileKind : uint8_t { Document, Product, ExecutableProduct };

/// Writes `content` to `path` so that a reader sees the old file or the new one, never a part: a
/// temporary file beside it, flushed to the disk if it is a document, then renamed. GL9002 on
/// failure, with nothing left behind. An executable gets mode 755.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                                 FileKind kind = FileKind::Document);

}  // namespace glider::support
