// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/difference/tick_text.h"

#include "ir/eval/arithmetic.h"
#include "ir/verify/value_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>
#include <variant>

namespace glider::analysis {
namespace {

struct CommandInfo {
  const char* text;
  std::vector<ir::Type> parameters;
};

/// The types of parameters, as ir/core/commands.def names them.
namespace types {
constexpr ir::Type length{ir::TypeKind::Quantity, support::dimension::length};
constexpr ir::Type angle{ir::TypeKind::Quantity, support::dimension::angle};
constexpr ir::Type volume{ir::TypeKind::Quantity, support::dimension::volume};
constexpr ir::Type speed{ir::TypeKind::Quantity, support::dimension::speed};
constexpr ir::Type latitude{ir::TypeKind::Latitude, {}};
constexpr ir::Type longitude{ir::TypeKind::Longitude, {}};
}  // namespace types

const CommandInfo& infoOf(ir::Command command) {
  static const std::vector<CommandInfo> kCommands = {
#define COMMAND(name, text, symbol, ...) {text, {__VA_ARGS__}},
#define PARAMETER(name, type) types::type,
#include "ir/core/commands.def"
#undef PARAMETER
#undef COMMAND
  };
  return kCommands.at(static_cast<size_t>(command));
}

std::string valueText(double value, const ir::Type& type) {
  if (!ir::isKnown(value)) {
    return "unknown";
  }
  return type == types::angle ? fmt::format("{:.6g} deg", value * 180 / std::numbers::pi)
                              : ir::withUnit(value, type);
}

std::string commandText(const ir::CommandRun& run) {
  const CommandInfo& info = infoOf(run.command);
  if (run.command == ir::Command::Battery && ir::isKnown(run.arguments.at(0))) {
    constexpr double kMetresPerInch = 0.0254;
    return fmt::format("{}({:.6g} inch)", info.text, run.arguments.at(0) / kMetresPerInch);
  }
  std::vector<std::string> arguments;
  for (size_t i = 0; i < run.arguments.size(); ++i) {
    arguments.push_back(valueText(run.arguments[i], info.parameters.at(i)));
  }
  return fmt::format("{}({})", info.text, fmt::join(arguments, ", "));
}

std::string moveText(const ir::TickResult& result, ir::StateId before, const ir::Mission& mission,
                     const std::vector<std::string>& names) {
  if (result.finished) {
    return "ends the mission";
  }
  if (!result.moved) {
    return result.state == before ? "" : fmt::format("begins in `{}`", names[result.state.index]);
  }
  const auto& cases =
      result.moved->list == ir::ListKind::Always ? mission.always : mission[before].cases;
  const ir::Transition transition = cases.at(result.moved->number).transition;
  const char* how = transition == ir::Transition::Call     ? "calls"
                    : transition == ir::Transition::Return ? "returns to"
                                                           : "goes to";
  return fmt::format("{} `{}`", how, names[result.state.index]);
}

}  // namespace

std::string tickText(const ir::Mission& mission, const ir::TickResult& result, ir::StateId before,
                     const std::vector<std::string>& names) {
  std::string text = moveText(result, before, mission, names);
  std::vector<std::string> commands;
  for (const ir::Action& action : result.actions) {
    const auto* run = std::get_if<ir::CommandRun>(&action);
    if (run != nullptr && !run->refused) {
      commands.push_back(commandText(*run));
    }
  }
  if (!commands.empty()) {
    text += fmt::format("{}commands {}", text.empty() ? "" : " and ", fmt::join(commands, ", "));
  }
  return text.empty() ? "does nothing" : text;
}

std::vector<std::string> readingsText(const ir::Mission& mission,
                                      const ir::Interpreter& interpreter) {
  std::vector<std::string> lines;
  for (uint32_t i = 0; i < mission.sensors.size(); ++i) {
    const double value = interpreter.readingOf({i});
    if (ir::isKnown(value)) {
      lines.push_back(fmt::format("{} = {}", mission.sensors[i].name,
                                  valueText(value, mission.sensors[i].type)));
    }
  }
  return lines;
}

}  // namespace glider::analysis
