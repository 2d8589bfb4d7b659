// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/port_sources.h"

#include "support/files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace glider::driver {
namespace {

namespace fs = std::filesystem;

fs::path whole(const std::string& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal();
}

/// The mission file, and what it imports.
std::vector<fs::path> filesOf(const compiler::Optimised& mission, const std::string& mission_file) {
  const compiler::Lowered& lowered = *mission.checked->lowered;
  std::vector<fs::path> files{whole(mission_file)};
  for (uint32_t file = 1; file < mission.sources().count(); ++file) {
    if (!lowered.inStandardLibrary(file)) {
      files.push_back(whole(mission.sources().name(file)));
    }
  }
  std::ranges::sort(files.begin() + 1, files.end());
  files.erase(std::unique(files.begin() + 1, files.end()), files.end());
  return files;
}

/// The deepest folder that all are in.
fs::path commonFolder(const std::vector<fs::path>& files) {
  fs::path common = files.front().parent_path();
  const auto holds = [&](const fs::path& file) {
    return std::mismatch(common.begin(), common.end(), file.begin(), file.end()).first ==
           common.end();
  };
  while (common != common.root_path() && !std::ranges::all_of(files, holds)) {
    common = common.parent_path();
  }
  return common;
}

}  // namespace

support::Result<PortSources> portSources(const compiler::Optimised& mission,
                                         const std::string& mission_file,
                                         const std::string& alone) {
  const std::vector<fs::path> files = filesOf(mission, mission_file);
  const fs::path common = commonFolder(files);
  PortSources sources;
  for (const fs::path& file : files) {
    auto text = support::readFile(file);
    if (!text) {
      return std::unexpected(text.error());
    }
    const std::string name =
        files.size() == 1 ? alone : ("source" / file.lexically_relative(common)).generic_string();
    sources.files.emplace_back(name, std::move(*text));
  }
  sources.mission = sources.files.front().first;
  return sources;
}

}  // namespace glider::driver
