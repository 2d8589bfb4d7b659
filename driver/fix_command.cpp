// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/commands.h"
#include "driver/compilation.h"
#include "driver/exit_code.h"
#include "driver/line_diff.h"
#include "driver/rewrite.h"
#include "driver/terminal.h"
#include "support/diagnostics/fixes.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace glider::driver {
namespace {

using support::Diagnostic;
using support::Result;

/// Fix-its that undo each other must not go on for ever.
constexpr int kMostRounds = 100;

/// A mission's errors, stage by stage: while one stage has errors, those of the next are hidden.
using Errors = std::array<size_t, 3>;

Errors errorsOf(const Compilation& compilation) {
  constexpr size_t kPerStage = 1000;
  Errors errors{};
  for (const Diagnostic& diagnostic : compilation.diagnostics.sorted()) {
    const size_t stage = static_cast<size_t>(diagnostic.id) / kPerStage;  // GL1xxx is syntax
    const bool error = diagnostic.severity == support::Severity::Error;
    errors[std::clamp<size_t>(stage, 1, errors.size()) - 1] += error ? 1U : 0U;
  }
  return errors;
}

/// A mission on its way to have no more fix-its.
struct Fixing {
  std::unique_ptr<Compilation> last;
  std::string report;
  Errors before{};
};

std::string reportOf(const Compilation& compilation, const std::vector<Diagnostic>& fixed) {
  std::string out;
  for (const Diagnostic& diagnostic : fixed) {
    const support::LineColumn at =
        compilation.sources.place(compilation.file, diagnostic.range.begin);
    out += fmt::format("{}:{}:{}: fixed [{} {}] {}\n", compilation.sources.name(compilation.file),
                       at.line, at.column, support::code(diagnostic.id),
                       support::catalogueRow(diagnostic.id).slug, diagnostic.message);
  }
  return out;
}

/// Applies fix-its, round after round, until none is left.
Result<Fixing> applyAll(const std::string& path, const std::string& text) {
  auto compiled = compileText(path, text);
  if (!compiled) {
    return std::unexpected(compiled.error());
  }
  Fixing fixing{std::move(*compiled), {}, {}};
  fixing.before = errorsOf(*fixing.last);
  for (int round = 0; round < kMostRounds; ++round) {
    const Compilation& last = *fixing.last;
    const support::FixedText next =
        support::applyFixes(last.sources.text(last.file), last.file, last.diagnostics.sorted());
    if (next.fixed.empty()) {
      break;
    }
    fixing.report += reportOf(last, next.fixed);
    compiled = compileText(path, next.text);
    if (!compiled) {
      return std::unexpected(compiled.error());
    }
    fixing.last = std::move(*compiled);
  }
  return fixing;
}

int fix(const std::string& path, bool dry_run) {
  const auto text = support::readFile(path);
  const auto fixing = text ? applyAll(path, *text) : std::unexpected(text.error());
  if (!fixing) {
    return reportFailure(fixing.error());
  }
  const Compilation& last = *fixing->last;
  if (errorsOf(last) > fixing->before) {
    reportFailure(support::fail(support::DiagnosticId::fixesNotKept, path).error());
    return kMissionHasErrors;
  }
  const std::string& fixed = last.sources.text(last.file);
  const auto written = dry_run || fixed == *text ? Result<void>{} : rewriteFile(path, fixed);
  if (!written) {
    return reportFailure(written.error());
  }
  std::string report = fixing->report.empty() ? path + ": nothing to fix\n" : fixing->report;
  const auto printed = printOut(dry_run ? report + lineDiff(path, *text, fixed) : report);
  reportDiagnostics(last.diagnostics, last.sources);
  if (!printed) {
    return reportFailure(printed.error());
  }
  return last.diagnostics.hasErrors() ? kMissionHasErrors : kFine;
}

}  // namespace

void addFixCommand(CLI::App& app, int& status) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto dry_run = std::make_shared<bool>(false);
  CLI::App* command =
      app.add_subcommand("fix", "Mend the mistakes whose repair is plain, and report the others");
  command->add_option("FILE", *files, "Mission files")->required();
  command->add_flag("--dry-run", *dry_run, "Write nothing; show what would change");
  command->callback([files, dry_run, &status] {
    for (const std::string& path : *files) {
      status = std::max(status, fix(path, *dry_run));
    }
  });
}

}  // namespace glider::driver
