// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/share.h"

#include <cstdlib>
#include <system_error>

namespace glider::compiler {

std::filesystem::path shareDirectory() {
  if (const char* named = std::getenv("GLIDERCC_SHARE"); named != nullptr && *named != '\0') {
    return named;
  }
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return program.parent_path().parent_path() / "share" / "glidercc";
}

}  // namespace glider::compiler
