// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/vehicles_own.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/output/line_diff.h"
#include "driver/output/rewrite.h"
#include "driver/terminal.h"
#include "frontend/format/format.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace glider::driver {
namespace {

struct FmtOptions {
  std::vector<std::string> files;
  bool check = false;
  bool diff = false;
};

support::Result<void> put(const FmtOptions& options, const std::string& path,
                          const std::string& before, const std::string& after) {
  const bool standard = path == "-";
  if (options.diff) {
    return printOut(lineDiff(standard ? "standard input" : path, before, after));
  }
  if (options.check) {
    return before == after ? support::Result<void>{}
                           : printOut((standard ? "standard input" : path) + "\n");
  }
  if (standard) {
    return printOut(after);
  }
  return before == after ? support::Result<void>{} : rewriteFile(path, after);
}

int format(const FmtOptions& options, const std::string& path) {
  if (const auto kind = compiler::requireKind(path, compiler::MissionKind::Language); !kind) {
    return reportFailure(kind.error());
  }
  auto text = path == "-" ? support::readFile("/dev/stdin") : support::readFile(path);
  if (!text) {
    return reportFailure(text.error());
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const uint32_t file = sources.add(path == "-" ? "standard input" : path, std::move(*text));
  const auto formatted = frontend::format(sources, file, diagnostics);
  reportDiagnostics(diagnostics, sources);
  if (!formatted) {
    return kMissionHasErrors;
  }
  const auto done = put(options, path, sources.text(file), *formatted);
  if (!done) {
    return reportFailure(done.error());
  }
  return options.check && *formatted != sources.text(file) ? kMissionHasErrors : kFine;
}

}  // namespace

void addFmtCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<FmtOptions>();
  CLI::App* command = app.add_subcommand("fmt", "Format mission files; comments are kept");
  command->add_option("MISSION", options->files, "Mission or library files; `-` is standard input")
      ->required();
  command->add_flag(
      "--check", options->check,
      "List the files that would change without writing them; exit with 1 if there are any");
  command->add_flag("--diff", options->diff, "Show what would change without writing files");
  command->callback([options, &status] {
    for (const std::string& path : options->files) {
      status = std::max(status, format(*options, path));
    }
  });
}

}  // namespace glider::driver
