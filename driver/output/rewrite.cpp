// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/rewrite.h"

#include "support/diagnostics/ids/files.h"
#include "support/files.h"

#include <system_error>

namespace glider::driver {

support::Result<void> rewriteFile(const std::filesystem::path& path, std::string_view text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  const fs::perms permissions = error ? fs::perms::unknown : fs::status(real, error).permissions();
  if (error) {
    return support::fail(support::diagnostics::cannotWrite, path.string(), error.message());
  }
  auto written = support::writeFileAtomically(real, text);
  if (written && fs::is_regular_file(real, error)) {
    fs::permissions(real, permissions, error);
  }
  return written;
}

}  // namespace glider::driver
