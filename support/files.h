// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace glider::support {

/// The largest file that is read unless more is asked for.
inline constexpr size_t kLargestFile = size_t{64} << 20U;

/// The whole content of `path`; GL9001 when it cannot be read (missing, a directory, more than
/// `largest` bytes, an I/O error).
Result<std::string> readFile(const std::filesystem::path& path, size_t largest = kLargestFile);

/// What is written, which decides how: a product can be rebuilt, so writing it does not wait for
/// the disk, and a power cut may lose it.
enum class FileKind : uint8_t { Document, Product, ExecutableProduct };

/// True if a file can be put at `path` by a rename; false for what must be written to directly: a
/// device, a pipe, the name of an open descriptor (/dev/stdout, /dev/fd/3).
bool isReplaceable(const std::filesystem::path& path);

/// A file's new content, whole, in a temporary file beside it: for several files that must appear
/// together. Unless published, it is deleted at the end of the scope.
class StagedFile {
 public:
  /// Writes `content` to the temporary file, and to the disk if it is a document. Symbolic links
  /// are followed: the file that `path` leads to will be replaced. GL9002.
  static Result<StagedFile> write(const std::filesystem::path& path, std::string_view content,
                                  FileKind kind);
  StagedFile(StagedFile&& other) noexcept
      : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, {})) {}
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();
  /// Renames it to its place. GL9002.
  Result<void> publish();

 private:
  StagedFile() = default;
  std::filesystem::path path_;
  std::string temporary_;
};

/// Writes `content` to `path` so that a reader sees the old file or the new one, never a part: a
/// staged file, published. What is not replaceable is written to directly. GL9002 on failure, with
/// nothing left behind. An executable gets mode 755.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                                 FileKind kind = FileKind::Document);

}  // namespace glider::support
