// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/terminal.h"
#include "logs/render.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

namespace glider::driver {
namespace {

using support::DiagnosticId;
using support::Result;

struct LogOptions {
  std::string file;
  std::string csv;
};

/// "3 incomplete or damaged and skipped, 2 missing (or more, by a multiple of 256)".
std::string damageText(const logs::LogDamage& damage) {
  std::string text;
  const auto add = [&](uint32_t count, const char* what) {
    if (count > 0) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
    }
  };
  add(damage.bad, "incomplete or damaged and skipped");
  add(damage.missing, "missing (or more, by a multiple of 256)");
  add(damage.unreadable, "of another version or invalid");
  return text;
}

Result<void> write(const LogOptions& options, const std::string& text) {
  return options.csv.empty() || options.csv == "-"
             ? printOut(text)
             : support::writeFileAtomically(options.csv, text);
}

int log(const LogOptions& options) {
  const auto bytes = support::readFile(options.file);
  if (!bytes) {
    return reportFailure(bytes.error());
  }
  std::error_code ignored;
  if (!options.csv.empty() && std::filesystem::equivalent(options.file, options.csv, ignored)) {
    return reportFailure(support::fail(DiagnosticId::outputIsInput, options.file).error());
  }
  std::string text = options.csv.empty() ? "" : logs::kLogCsvHead;
  const logs::LogDamage damage = logs::readLog(*bytes, [&](const logs::LogEntry& entry) {
    text += options.csv.empty() ? logs::textLine(entry) : logs::csvLines(entry);
  });
  if (damage.starts == 0) {
    std::string why = bytes->empty() ? "it is empty" : "it contains no complete header of a log";
    if (const std::string older = options.file + ".old"; std::filesystem::exists(older, ignored)) {
      why += "; earlier records are in `" + older + "`";
    }
    return reportFailure(support::fail(DiagnosticId::noLog, options.file, why).error());
  }
  if (const auto written = write(options, text); !written) {
    return reportFailure(written.error());
  }
  if (const std::string harm = damageText(damage); !harm.empty()) {
    tell(fmt::format("glidercc: note: {}: records: {}\n", options.file, harm));
  }
  return kFine;
}

}  // namespace

void addLogCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<LogOptions>();
  CLI::App* command = app.add_subcommand("log", "Show the log written by a mission on the SBC");
  command->add_option("FILE", options->file, "Log file written by the mission's program with --log")
      ->required();
  command
      ->add_option(
          "--csv", options->csv,
          "Write comma-separated values instead, one row per value; `-` is standard output")
      ->option_text("OUT");
  command->callback([options, &status] { status = log(*options); });
}

}  // namespace glider::driver
