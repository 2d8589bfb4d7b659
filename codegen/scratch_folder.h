// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace glider::codegen {

/// A new folder for files of this process, removed with its content at the end of the scope.
class ScratchFolder {
 public:
  /// Makes one in the system's folder for temporary files. GL9002 if that fails.
  static support::Result<ScratchFolder> make();
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file `name` in this folder; returns its path. GL9002 if there is no room.
  support::Result<std::filesystem::path> write(const std::string& name,
                                               std::string_view content) const;

 private:
  explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;  ///< empty after a move
};

}  // namespace glider::codegen
