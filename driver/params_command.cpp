// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/parameter_rows.h"
#include "compiler/compilation.h"
#include "driver/commands.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
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
  bool json = false;
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

std::string describe(const std::string& mission,
                     const std::vector<analysis::ParameterRow>& parameters) {
  if (parameters.empty()) {
    return fmt::format("mission {} has no parameters\n", mission);
  }
  std::vector<Row> rows{{"name", "type", "default", "range", "set to"}};
  for (const analysis::ParameterRow& one : parameters) {
    rows.push_back({one.name, one.type, one.initial, one.range, one.set_to});
  }
  if (std::ranges::all_of(rows.begin() + 1, rows.end(),
                          [](const Row& row) { return row[4].empty(); })) {
    rows.front()[4].clear();
  }
  return table(rows);
}

/// The members of the document: the texts as in the table; `set_to` is null for the default.
void put(Json& document, const std::string& mission,
         const std::vector<analysis::ParameterRow>& parameters) {
  document["mission"] = mission;
  document["parameters"] = Json::array();
  for (const analysis::ParameterRow& one : parameters) {
    document["parameters"].push_back({{"name", one.name},
                                      {"type", one.type},
                                      {"default", one.initial},
                                      {"range", one.range.empty() ? Json() : Json(one.range)},
                                      {"set_to", one.set_to.empty() ? Json() : Json(one.set_to)}});
  }
}

int params(const ParamsOptions& options, Json* document) {
  int status = kFine;
  const auto mission = compileForFlight(options.mission, status);
  if (mission == nullptr) {
    return status;
  }
  const auto parameters = analysis::parameterRows(*mission, options.launch);
  if (!parameters) {
    return reportFailure(parameters.error());
  }
  if (document != nullptr) {
    put(*document, mission->mission.name, *parameters);
    return kFine;
  }
  const auto printed = printOut(describe(mission->mission.name, *parameters));
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

void addParamsCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<ParamsOptions>();
  CLI::App* command = app.add_subcommand(
      "params", "List a mission's parameters: types, defaults, ranges and changed values");
  command->add_option("MISSION", options->mission, "The mission file")->required();
  addLaunchOptions(*command, options->launch);
  addFormatOption(*command, options->json);
  command->callback([options, &status] {
    status = inFormat(options->json, "params",
                      [&](Json* document) { return params(*options, document); });
  });
}

}  // namespace glider::driver
