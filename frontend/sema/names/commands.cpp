// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/commands.h"

#include "support/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace glider::frontend {
namespace {

struct ParameterRow {
  std::string_view name;
  std::string_view type;
};
struct CommandRow {
  ir::Command command;
  std::string_view text;
  std::vector<ParameterRow> parameters;
};

std::vector<CommandRow> rows() {
  return {
#define PARAMETER(name, type) {#name, #type},
#define COMMAND(name, text, symbol, parameters) {ir::Command::name, text, {parameters}},
#include "ir/core/commands.def"
#undef COMMAND
#undef PARAMETER
  };
}

/// Without a place: it means the usual pitch or speed of the vehicle.
const ast::Expr kUsualSlope;

bool isSlope(std::string_view parameter) {
  return parameter == "pitch" || parameter == "speed";
}

VehicleCommand build(const CommandRow& row, std::string_view name) {
  // The names of the parameters live as long as the program.
  static std::vector<std::unique_ptr<ast::Name>> names;
  VehicleCommand result{row.command, std::string(name), {}};
  for (const ParameterRow& parameter : row.parameters) {
    const auto type = findType(parameter.type);
    CHECK(type.has_value(), "a command's parameter has no type");
    names.push_back(std::make_unique<ast::Name>(ast::Name{std::string(parameter.name), {}}));
    result.signature.formals.push_back(
        {names.back().get(), *type, isSlope(parameter.name) ? &kUsualSlope : nullptr});
    result.signature.slots.push_back({std::string(parameter.name), type->type});
    result.signature.text += fmt::format("{}{}: {}", result.signature.text.empty() ? "" : ", ",
                                         parameter.name, parameter.type);
  }
  result.signature.text = fmt::format("{}({})", name, result.signature.text);
  return result;
}

/// What a mission calls the command on a vehicle that takes a speed, or a pitch; empty: it does not
/// have it.
std::string_view nameOf(const CommandRow& row, bool by_speed) {
  switch (row.command) {
    case ir::Command::Descend:
    case ir::Command::Ascend:
    case ir::Command::Hover:
    case ir::Command::Fin:
    case ir::Command::Pump:
    case ir::Command::Battery:
      return by_speed ? "" : row.text;
    case ir::Command::DescendAt:
      return by_speed ? "descend" : "";
    case ir::Command::AscendAt:
      return by_speed ? "ascend" : "";
    case ir::Command::Surface:
    case ir::Command::Steer:
    case ir::Command::SteerTo:
    case ir::Command::Drift:
      break;
  }
  return row.text;
}

std::vector<VehicleCommand> commandsOf(bool by_speed) {
  std::vector<VehicleCommand> list;
  for (const CommandRow& row : rows()) {
    if (const std::string_view name = nameOf(row, by_speed); !name.empty()) {
      list.push_back(build(row, name));
    }
  }
  return list;
}

}  // namespace

const std::vector<VehicleCommand>& vehicleCommands(const platforms::Platform& platform) {
  static const std::vector<VehicleCommand> by_pitch = commandsOf(false);
  static const std::vector<VehicleCommand> by_speed = commandsOf(true);
  return platform.envelope.steersBySpeed() ? by_speed : by_pitch;
}

bool isCommandName(std::string_view name) {
  return std::ranges::any_of(rows(), [&](const CommandRow& row) {
    return nameOf(row, false) == name || nameOf(row, true) == name;
  });
}

}  // namespace glider::frontend
