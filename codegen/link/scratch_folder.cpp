// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/link/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

namespace glider::codegen {

support::Result<ScratchFolder> ScratchFolder::make() {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
  std::string name = (parent / "glidercc-XXXXXX").string();
  if (error || ::mkdtemp(name.data()) == nullptr) {
    return support::fail(support::DiagnosticId::cannotWrite, name,
                         error ? error.message() : std::strerror(errno));
  }
  return ScratchFolder(name);
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

ScratchFolder::~ScratchFolder() {
  if (!path_.empty()) {
    std::error_code ignored;  // it is temporary anyway
    std::filesystem::remove_all(path_, ignored);
  }
}

}  // namespace glider::codegen
