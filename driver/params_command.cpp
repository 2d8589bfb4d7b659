// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/compilation.h"
#include "driver/commands.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"
#include "flights/launch_choice.h"
#include "runtime/launch/launch.h"

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

template <typename Write>
std::string written(Write write) {
  std::array<char, 120> bytes{};
  runtime::Text text(bytes.data(), bytes.size());
  write(text);
  return {text.bytes(), text.size()};
}

std::string typeName(const ir::Type& type) {
  switch (type.kind) {
    case ir::TypeKind::Bool:
      return "bool";
    case ir::TypeKind::Latitude:
      return "latitude";
    case ir::TypeKind::Longitude:
      return "longitude";
    case ir::TypeKind::Quantity:
      break;
  }
  return support::describe(type.dimension);
}

using Row = std::array<std::string, 5>;

Row rowOf(const ir::Variable& variable, const GliderParameterInfo& info, double value) {
  auto quantity = [&](double of) {
    return written([&](runtime::Text& text) { runtime::writeQuantity(info, of, text); });
  };
  return {variable.name, typeName(variable.type), quantity(info.initial),
          written([&](runtime::Text& text) { runtime::writeRange(info, text); }),
          value == info.initial ? "" : quantity(value)};
}

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
  const auto loaded = flights::loadForParameters(mission);
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  const GliderMission& info = loaded->mission();
  const auto values = flights::chooseParameters(info, choice);
  if (!values) {
    return std::unexpected(values.error());
  }
  if (values->empty()) {
    return fmt::format("mission {} has no parameters\n", mission.mission.name);
  }
  std::vector<Row> rows{{"name", "type", "default", "range", "set to"}};
  for (size_t i = 0; i < values->size(); ++i) {
    rows.push_back(rowOf(mission.mission.variables[i], info.parameters[i], values->at(i)));
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
