// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/compilation.h"
#include "compiler/vehicles_own.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
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
#include <string>
#include <vector>

namespace glider::driver {
namespace {

using support::Diagnostic;
using support::Fixing;
using support::Result;

std::string reportOf(const std::string& path, const Fixing& fixing) {
  std::string out;
  for (const Fixing::Round& round : fixing.rounds) {
    support::SourceManager sources;
    const uint32_t file = sources.add(path, round.before);
    for (const Diagnostic& diagnostic : round.fixed) {
      const support::LineColumn at = sources.place(file, diagnostic.range.begin);
      out += fmt::format("{}:{}:{}: fixed [{} {}] {}\n", path, at.line, at.column,
                         support::code(diagnostic.id), support::catalogueRow(diagnostic.id).slug,
                         diagnostic.message);
    }
  }
  return out.empty() ? path + ": nothing to fix\n" : out;
}

/// Replaces the file's text with the fixed text, or shows what that would change.
Result<void> put(const std::string& path, const std::string& before, const Fixing& fixing,
                 bool dry_run) {
  if (!dry_run && fixing.text != before) {
    if (auto written = rewriteFile(path, fixing.text); !written) {
      return written;
    }
  }
  return printOut(reportOf(path, fixing) + (dry_run ? lineDiff(path, before, fixing.text) : ""));
}

int fix(const std::string& path, bool dry_run) {
  if (auto kind = compiler::requireKind(path, compiler::MissionKind::Language); !kind) {
    return reportFailure(kind.error());
  }
  const auto text = support::readFile(path);
  if (!text) {
    return reportFailure(text.error());
  }
  std::optional<compiler::Compilation> last;
  const auto check = [&](const std::string& candidate) -> Result<std::vector<Diagnostic>> {
    auto compiled = compiler::compileText(path, candidate);
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
  const auto done = put(path, *text, *fixing, dry_run);
  if (!done) {
    return reportFailure(done.error());
  }
  reportDiagnostics(last->diagnostics, *last->sources);
  return last->diagnostics.hasErrors() ? kMissionHasErrors : kFine;
}

}  // namespace

void addFixCommand(CLI::App& app, int& status) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto dry_run = std::make_shared<bool>(false);
  CLI::App* command =
      app.add_subcommand("fix", "Apply automatic fixes and report remaining errors");
  command->add_option("FILE", *files, "Mission files")->required();
  command->add_flag("--dry-run", *dry_run, "Show what would change without writing files");
  command->callback([files, dry_run, &status] {
    for (const std::string& path : *files) {
      status = std::max(status, fix(path, *dry_run));
    }
  });
}

}  // namespace glider::driver
