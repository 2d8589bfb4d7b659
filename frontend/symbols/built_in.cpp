// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/symbols/built_in.h"

#include "frontend/sema/names/commands.h"
#include "frontend/sema/names/functions.h"
#include "frontend/sema/names/scope.h"
#include "frontend/sema/names/values.h"
#include "frontend/symbols/type_texts.h"

#include <fmt/format.h>

#include <iterator>

namespace glider::frontend {
namespace {

/// In the order of Clock.
constexpr std::string_view kClockTexts[] = {
    "time since the computer in the payload bay got control",
    "time since the state was entered",
    "time since the state last became current",
};

Symbol symbol(SymbolKind kind, std::string_view name, std::string_view type,
              std::string_view description) {
  Symbol result;
  result.kind = kind;
  result.name = name;
  result.type = type;
  result.unit = unitOf(type);
  result.description = description;
  return result;
}

Symbol sensorSymbol(const platforms::PlatformSensor& sensor) {
  const bool alias = !sensor.alias.empty() && sensor.alias != sensor.name;
  Symbol result =
      symbol(SymbolKind::Sensor, alias ? sensor.alias : sensor.name, typeOf(sensor), sensor.what);
  result.vehicle_name = alias ? sensor.name : "";
  return result;
}

}  // namespace

std::vector<Symbol> builtIn(const platforms::Platform& platform) {
  std::vector<Symbol> all;
  if (!platform.name.empty()) {
    all.push_back(symbol(SymbolKind::Platform, platform.name, platform.name, platform.description));
  }
  for (const platforms::PlatformSensor& sensor : platform.sensors) {
    all.push_back(sensorSymbol(sensor));
  }
  for (size_t i = 0; i < std::size(kClockTexts); ++i) {
    all.push_back(symbol(SymbolKind::Clock, clockNames()[i], "time", kClockTexts[i]));
  }
  all.push_back(symbol(SymbolKind::Condition, "profiledone", "bool",
                       "whether the flightprofile of the state is done"));
  all.push_back(symbol(SymbolKind::Condition, "routedone", "bool",
                       "whether the flightroute of the state is done"));
  for (const ValueText& value : valueTexts()) {
    const auto kind = value.type == "bool" ? SymbolKind::Condition : SymbolKind::Clock;
    all.push_back(symbol(kind, value.name, value.type, value.what));
  }
  for (const platforms::PlatformSensor& sensor : platform.sensors) {
    for (size_t i = 0; i < sensor.states.size(); ++i) {
      all.push_back(symbol(SymbolKind::Condition, sensor.states[i], "bool",
                           fmt::format("whether {} is {}", sensor.name, i)));
    }
  }
  for (const FunctionText& function : functionTexts()) {
    all.push_back(symbol(SymbolKind::Function, function.name, function.use, function.what));
  }
  for (const VehicleCommand& command : vehicleCommands(platform)) {
    all.push_back(symbol(SymbolKind::Command, command.name, command.signature.text,
                         "command, in force until the next of its kind"));
  }
  all.push_back(symbol(SymbolKind::Command, "push", "push(array, value)",
                       "puts a value at the front of an array and forgets the oldest"));
  return all;
}

}  // namespace glider::frontend
