// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/scratch_folder.h"

#include "support/diagnostics/ids/files.h"

#include <cerrno>
#include <cstdio>
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
    return support::fail(support::diagnostics::cannotWrite, name,
                         error ? error.message() : std::strerror(errno));
  }
  return ScratchFolder(name);
}

support::Result<std::filesystem::path> ScratchFolder::write(const std::string& name,
                                                            std::string_view content) const {
  // Not support::writeFileAtomically: no one else reads the file, and waiting for the disk would
  // take longer than compiling.
  const std::filesystem::path file = path_ / name;
  std::FILE* stream = std::fopen(file.c_str(), "wbe");
  bool written =
      stream != nullptr && std::fwrite(content.data(), 1, content.size(), stream) == content.size();
  written = (stream == nullptr || std::fclose(stream) == 0) && written;
  if (!written) {
    return support::fail(support::diagnostics::cannotWrite, file.string(), std::strerror(errno));
  }
  return file;
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
