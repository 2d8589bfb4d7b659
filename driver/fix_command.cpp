// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/compilation.h"
#include "compiler/vehicles_own.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/output/check_on_terminal.h"
#include "driver/output/line_diff.h"
#include "driver/output/rewrite.h"
#include "driver/terminal.h"
#include "frontend/constructs.h"
#include "support/diagnostics/fixes.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glider::driver {
namespace {

using support::Diagnostic;
using support::Fixing;
using support::Result;

/// A line for each change, made or only shown; empty if there is none.
std::string reportOf(const std::string& name, const Fixing& fixing, bool dry_run) {
  std::string out;
  for (const Fixing::Round& round : fixing.rounds) {
    support::SourceManager sources;
    const uint32_t file = sources.add(name, round.before);
    for (const Diagnostic& diagnostic : round.fixed) {
      const support::LineColumn at = sources.place(file, diagnostic.range.begin);
      out += fmt::format("{}:{}:{}: {} [{} {}] {}\n", name, at.line, at.column,
                         dry_run ? "would fix" : "fixed", support::code(diagnostic.id),
                         support::catalogueRow(diagnostic.id).slug, diagnostic.message);
    }
  }
  return out;
}

/// Replaces the file's text with the fixed text, or shows what that would change. The text of
/// standard input goes to standard output, where a report would spoil it.
Result<void> put(const std::string& path, const std::string& before, const Fixing& fixing,
                 bool dry_run) {
  const std::string name = compiler::shownName(path);
  const std::string report = reportOf(name, fixing, dry_run);
  if (path == compiler::kStandardInput) {
    tell(report);
    return printOut(dry_run ? lineDiff(name, before, fixing.text) : fixing.text);
  }
  if (!dry_run && fixing.text != before) {
    if (auto written = rewriteFile(path, fixing.text); !written) {
      return written;
    }
  }
  const auto told = printSuccess(report);
  return told && dry_run ? printOut(lineDiff(path, before, fixing.text)) : told;
}

/// Reports the errors that remain, those of proofs too, and whether there was nothing to fix;
/// returns the exit code.
int reportRemaining(const std::string& path, compiler::Compilation last, bool changed,
                    bool dry_run) {
  const std::string name = compiler::shownName(path);
  const CheckedFile checked = checkOnTerminal(name, std::move(last), {});
  reportDiagnostics(checked.compilation->diagnostics, *checked.compilation->sources);
  if (checked.found.failure) {
    return reportFailure(*checked.found.failure);
  }
  const auto errors = std::ranges::count(checked.found.diagnostics, support::Severity::Error,
                                         &Diagnostic::severity);
  if (errors > 0) {
    const bool would = dry_run && changed;
    tell(fmt::format("{}: {}{} error{} {}remain{}\n", name,
                     changed ? "" : "nothing that can be fixed automatically; ", errors,
                     errors == 1 ? "" : "s", would ? "would " : "",
                     errors == 1 && !would ? "s" : ""));
    return kMissionHasErrors;
  }
  const std::string nothing = changed ? "" : name + ": nothing to fix\n";
  if (path == compiler::kStandardInput) {
    tell(nothing);
    return kFine;
  }
  const auto told = printSuccess(nothing);
  return told ? kFine : reportFailure(told.error());
}

int fix(const std::string& path, bool dry_run) {
  if (auto kind = compiler::requireKind(path, compiler::MissionKind::Language); !kind) {
    return reportFailure(kind.error());
  }
  const auto text =
      support::readFile(path == compiler::kStandardInput ? std::string("/dev/stdin") : path);
  if (!text) {
    return reportFailure(text.error());
  }
  std::optional<compiler::Compilation> last;
  const auto check = [&](const std::string& candidate) -> Result<std::vector<Diagnostic>> {
    auto compiled = compiler::compileText(compiler::shownName(path), candidate);
    if (!compiled) {
      return std::unexpected(compiled.error());
    }
    last = std::move(*compiled);
    return last->diagnostics.sorted();
  };
  constexpr uint32_t kFile = 0;  // compileText adds the mission first
  const auto fixing = support::fixAll(*text, kFile, {check, frontend::constructsOf});
  if (!fixing) {
    return reportFailure(fixing.error());
  }
  if (fixing->refused && fixing->rounds.empty()) {
    reportFailure(support::fail(support::diagnostics::fixesNotKept, path).error());
    return kMissionHasErrors;
  }
  if (const auto done = put(path, *text, *fixing, dry_run); !done) {
    return reportFailure(done.error());
  }
  return reportRemaining(path, std::move(*last), !fixing->rounds.empty(), dry_run);
}

}  // namespace

void addFixCommand(CLI::App& app, int& status) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto dry_run = std::make_shared<bool>(false);
  CLI::App* command =
      app.add_subcommand("fix", "Apply automatic fixes and report remaining errors");
  command
      ->add_option(
          "MISSION", *files,
          "Mission files; `-` is standard input, and the fixed text goes to standard output")
      ->required();
  command->add_flag("--dry-run", *dry_run, "Show what would change without writing files");
  command->callback([files, dry_run, &status] {
    for (const std::string& path : *files) {
      status = std::max(status, fix(path, *dry_run));
    }
  });
}

}  // namespace glider::driver
