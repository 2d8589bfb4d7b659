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
#include <utility>

namespace glider::driver {
namespace {

/// "1 error, 2 warnings" as a pilot would write it; empty if there is neither.
std::string counted(size_t errors, size_t warnings) {
  auto part = [](size_t n, const char* word) {
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

constexpr unsigned kMostEffort = 100;

struct CheckOptions {
  std::string mission;
  unsigned effort = 1;
};

/// ", 3 requirements proved"; empty if the mission requires nothing.
std::string provedLine(const ir::prove::Findings& findings) {
  const size_t all = findings.requirements.size();
  const auto proved = static_cast<size_t>(std::ranges::count(
      findings.requirements, ir::prove::Verdict::Proved, &ir::prove::RequirementVerdict::verdict));
  return all == 0       ? ""
         : proved < all ? fmt::format(", {} of {} requirements proved", proved, all)
                        : fmt::format(", {} requirement{} proved", all, all == 1 ? "" : "s");
}

int check(const CheckOptions& options) {
  const std::string& path = options.mission;
  auto compiled = compileMission(path);
  if (!compiled) {
    return reportFailure(compiled.error());
  }
  Compilation& compilation = **compiled;
  ir::prove::Findings findings;
  if (compilation.ok()) {
    ir::prove::Options effort;
    effort.effort *= options.effort;
    effort.run_effort *= options.effort;
    auto proved = proveMission(compilation, effort);
    if (!proved) {
      return reportFailure(proved.error());
    }
    findings = std::move(*proved);
  }
  reportDiagnostics(compilation.diagnostics, compilation.sources);
  const std::string found =
      counted(compilation.diagnostics.errorCount(), compilation.diagnostics.warningCount());
  if (!compilation.ok()) {
    tell(fmt::format("{}: {}\n", path, found));
    return kMissionHasErrors;
  }
  const std::string text =
      fmt::format("{}: {}; mission {}, {} states, {}{}\n", path, found.empty() ? "fine" : found,
                  compilation.mission->name, compilation.mission->states.size(),
                  stackLine(compilation), provedLine(findings));
  const auto printed = printOut(text);
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

void addCheckCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Check a mission without building it");
  command->add_option("MISSION", options->mission, "The mission file")->required();
  command
      ->add_option("--effort", options->effort, "How many times the usual effort a proof may take")
      ->check(CLI::Range(1U, kMostEffort));
  command->callback([options, &status] { status = check(*options); });
}

}  // namespace glider::driver
