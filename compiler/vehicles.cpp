// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/vehicles.h"

#include "compiler/compilation.h"
#include "compiler/share.h"
#include "platforms/load/load_platform.h"
#include "support/diagnostics/ids/command.h"

#include <fmt/ranges.h>

#include <filesystem>
#include <set>

namespace glider::compiler {

support::Result<platforms::Platform> loadVehicle(const std::string& name) {
  const std::filesystem::path folder = shareDirectory() / "platforms";
  std::error_code ignored;
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == ".toml") {
      names.insert(entry.path().stem());
    }
  }
  if (names.contains(name) || names.empty()) {
    return platforms::loadPlatform(platformFile(name));
  }
  auto failure = support::fail(support::diagnostics::unknownPlatform, name);
  failure.error().hint = fmt::format("the platforms are: {}", fmt::join(names, ", "));
  return failure;
}

}  // namespace glider::compiler
