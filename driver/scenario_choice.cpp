// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/scenario_choice.h"

#include "driver/share.h"
#include "driver/terminal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

namespace glider::driver {
std::vector<std::string> scenarioNames() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(shareDirectory() / "scenarios", ignored)) {
    if (entry.path().extension() == ".toml") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

namespace {

/// A file as it is; a bare name among those that come with glidercc.
support::Result<std::filesystem::path> scenarioPath(const std::string& wanted) {
  if (wanted.ends_with(".toml")) {
    return wanted;
  }
  const auto names = scenarioNames();
  if (std::ranges::find(names, wanted) == names.end()) {
    return support::fail(support::DiagnosticId::unknownScenario, wanted,
                         fmt::to_string(fmt::join(names, ", ")));
  }
  return shareDirectory() / "scenarios" / (wanted + ".toml");
}

std::string checkSeed(const std::string& text) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = error == std::errc() && end == text.data() + text.size();
  return good ? "" : fmt::format("`{}` is no whole number from 0 to 2^64-1", text);
}

}  // namespace

support::Result<simulator::Scenario> chooseScenario(const std::string& wanted) {
  const auto path = scenarioPath(wanted);
  if (!path) {
    return std::unexpected(path.error());
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto scenario = simulator::loadScenario(*path, sources, diagnostics);
  reportDiagnostics(diagnostics, sources);
  return scenario;
}

CLI::Validator seedValidator() {
  return CLI::Validator(checkSeed, "", "seed");
}

}  // namespace glider::driver
