// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/scenario_choice.h"

#include "compiler/share.h"
#include "simulator/family/family.h"
#include "simulator/simulator.h"
#include "support/diagnostics/ids/flights.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace glider::flights {
std::vector<std::string> scenarioNames() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(compiler::shareDirectory() / "scenarios", ignored)) {
    if (entry.path().extension() == ".toml") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

namespace {

/// The path of a file, or of a scenario that comes with glidercc for a bare name.
support::Result<std::filesystem::path> scenarioPath(const std::string& wanted) {
  if (wanted.ends_with(".toml")) {
    return wanted;
  }
  const auto names = scenarioNames();
  if (std::ranges::find(names, wanted) == names.end()) {
    return support::fail(support::diagnostics::unknownScenario, wanted,
                         fmt::to_string(fmt::join(names, ", ")));
  }
  return compiler::shareDirectory() / "scenarios" / (wanted + ".toml");
}

}  // namespace

support::Result<simulator::Scenario> chooseScenario(const std::string& wanted,
                                                    const platforms::Platform& platform,
                                                    const support::ShowDiagnostics& show) {
  const auto path = scenarioPath(wanted);
  if (!path) {
    return std::unexpected(path.error());
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto scenario = simulator::loadScenario(*path, platform, sources, diagnostics);
  if (show) {
    show(diagnostics, sources);
  }
  return scenario;
}

support::Result<void> flyVehiclesOwn(const std::filesystem::path& file,
                                     const platforms::Platform& platform,
                                     simulator::Scenario& scenario,
                                     const support::ShowDiagnostics& show) {
  const simulator::Family* family = simulator::familyOf(platform);
  if (family == nullptr) {
    return simulator::checkPlatform(platform);  // which reports that
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto loaded = family->load_own(file, sources, diagnostics, scenario.own);
  if (show) {
    show(diagnostics, sources);
  }
  return loaded;
}

}  // namespace glider::flights
