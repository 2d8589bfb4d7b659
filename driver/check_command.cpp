// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/commands.h"
#include "driver/compilation.h"
#include "driver/exit_code.h"
#include "driver/terminal.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

namespace glider::driver {
namespace {

/// "1 error, 2 warnings" of what is shown, as a pilot would write it; empty if there is neither.
std::string counted(const support::DiagnosticEngine& diagnostics) {
  const auto shown = diagnostics.sorted();
  const auto count = [&](support::Severity severity) {
    return std::ranges::count(shown, severity, &support::Diagnostic::severity);
  };
  const auto errors = count(support::Severity::Error);
  const auto warnings = count(support::Severity::Warning);
  auto part = [](ptrdiff_t n, const char* word) {
    return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s");
  };
  std::string text = errors > 0 ? part(errors, "error") : "";
  if (warnings > 0) {
    text += (text.empty() ? "" : ", ") + part(warnings, "warning");
  }
  return text;
}

std::string stackLine(const Compilation& compilation) {
  const ir::MissionFacts& facts = compilation.facts;
  if (facts.stack_depth == 0) {
    return "no calls";
  }
  std::string path;
  for (const ir::StateId state : facts.deepest_path) {
    path += (path.empty() ? "" : " calls ") + (*compilation.mission)[state].name;
  }
  return fmt::format("greatest call depth {} ({})", facts.stack_depth, path);
}

int check(const std::string& path) {
  auto compiled = compileMission(path);
  if (!compiled) {
    return reportFailure(compiled.error());
  }
  Compilation& compilation = **compiled;
  if (compilation.ok()) {
    const auto proved = proveMission(compilation);
    if (!proved) {
      return reportFailure(proved.error());
    }
    for (const auto& line : proved->lines) { fmt::print("{}\n", line.text); }
  }
  reportDiagnostics(compilation.diagnostics, compilation.sources);
  const std::string found = counted(compilation.diagnostics);
  if (!compilation.ok()) {
    tell(fmt::format("{}: {}\n", path, found));
    return kMissionHasErrors;
  }
  const std::string text = fmt::format("{}: {}; mission {}, {} states, {}\n", path,
                                       found.empty() ? "fine" : found, compilation.mission->name,
                                       compilation.mission->states.size(), stackLine(compilation));
  const auto printed = printOut(text);
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

void addCheckCommand(CLI::App& app, int& status) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("check", "Check a mission without building it");
  command->add_option("MISSION", *path, "The mission file")->required();
  command->callback([path, &status] { status = check(*path); });
}

}  // namespace glider::driver
