// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/commands.h"

#include "support/check.h"

#include <fmt/format.h>

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

VehicleCommand build(const CommandRow& row) {
  // The names of the parameters live as long as the program.
  static std::vector<std::unique_ptr<ast::Name>> names;
  VehicleCommand result{row.command, std::string(row.text), {}};
  for (const ParameterRow& parameter : row.parameters) {
    const auto type = findType(parameter.type);
    CHECK(type.has_value(), "a command's parameter has no type");
    names.push_back(std::make_unique<ast::Name>(ast::Name{std::string(parameter.name), {}}));
    result.signature.formals.push_back({names.back().get(), *type});
    result.signature.slots.push_back({std::string(parameter.name), type->type});
    result.signature.text += fmt::format("{}{}: {}", result.signature.text.empty() ? "" : ", ",
                                         parameter.name, parameter.type);
  }
  result.signature.text = fmt::format("{}({})", row.text, result.signature.text);
  return result;
}

}  // namespace

const std::vector<VehicleCommand>& vehicleCommands() {
  static const std::vector<VehicleCommand> commands = [] {
    std::vector<VehicleCommand> list;
    for (const CommandRow& row : rows()) {
      list.push_back(build(row));
    }
    return list;
  }();
  return commands;
}

}  // namespace glider::frontend
