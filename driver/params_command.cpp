// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/parameter_rows.h"
#include "compiler/compilation.h"
#include "driver/commands.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"
#include "flights/launch_choice.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

namespace glider::driver {
namespace {

struct ParamsOptions {
  std::string mission;
  flights::LaunchChoice launch;
};

using Row = std::array<std::string, 5>;

/// Columns as wide as their longest cell; the last column only if it is not empty.
std::string table(const std::vector<Row>& rows) {
  std::array<size_t, 5> widths{};
  for (const Row& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) {
      widths.at(i) = std::max(widths.at(i), row.at(i).size());
    }
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) {
      line += fmt::format("{:<{}}  ", row.at(i), widths.at(i));
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

support::Result<std::string> describe(const compiler::Optimised& mission,
                                      const flights::LaunchChoice& choice) {
  const auto parameters = analysis::parameterRows(mission, choice);
  if (!parameters) {
    return std::unexpected(parameters.error());
  }
  if (parameters->empty()) {
    return fmt::format("mission {} has no parameters\n", mission.mission.name);
  }
  std::vector<Row> rows{{"name", "type", "default", "range", "set to"}};
  for (const analysis::ParameterRow& one : *parameters) {
    rows.push_back({one.name, one.type, one.initial, one.range, one.set_to});
  }
  if (std::ranges::all_of(rows.begin() + 1, rows.end(),
                          [](const Row& row) { return row[4].empty(); })) {
    rows.front()[4].clear();
  }
  return table(rows);
}

int params(const ParamsOptions& options) {
  int status = kFine;
  const auto mission = compileForFlight(options.mission, status);
  if (mission == nullptr) {
    return status;
  }
  const auto text = describe(*mission, options.launch);
  if (!text) {
    return reportFailure(text.error());
  }
  const auto printed = printOut(*text);
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

void addParamsCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<ParamsOptions>();
  CLI::App* command = app.add_subcommand(
      "params", "List a mission's parameters: types, defaults, ranges and changed values");
  command->add_option("MISSION", options->mission, "The mission file")->required();
  addLaunchOptions(*command, options->launch);
  command->callback([options, &status] { status = params(*options); });
}

}  // namespace glider::driver
