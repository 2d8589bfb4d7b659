// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/c_header.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace glider::ir {
namespace {

/// Values are in SI units, even those that the language shows in other units.
std::string siUnit(const support::Dimension& dimension) {
  if (dimension == support::dimension::pressure) {
    return "Pa";
  }
  return dimension == support::dimension::charge ? "C" : support::unitName(dimension);
}

/// The meaning of a value in C: "m", "degrees north", "0 or 1".
std::string inC(const Type& type) {
  switch (type.kind) {
    case TypeKind::Bool:
      return "0 or 1";
    case TypeKind::Latitude:
      return "degrees north";
    case TypeKind::Longitude:
      return "degrees east";
    case TypeKind::Quantity:
      break;
  }
  const std::string unit = siUnit(type.dimension);
  return unit.empty() ? "a number" : unit;
}

std::string rangeText(double lowest, double highest) {
  if (std::isinf(lowest) && std::isinf(highest)) {
    return "";
  }
  return fmt::format(", from {:.10g} to {:.10g}", lowest, highest);
}

/// "t: degC, salty: 0 or 1".
std::string parametersText(const std::vector<Parameter>& parameters) {
  std::vector<std::string> texts;
  for (const Parameter& parameter : parameters) {
    texts.push_back(fmt::format("{}: {}", parameter.name, inC(parameter.type)));
  }
  return fmt::format("({})", fmt::join(texts, ", "));
}

// The parameters have no names in C: a name of the language may be a keyword of C.

void add(std::string& text, const Function& function) {
  std::vector<std::string_view> types(function.parameters.size(), "double");
  text += fmt::format(
      "/* {}{}\n   gives {}{}. Each place in the mission calls it once a tick at most. */\n"
      "double function_{}({}) GLIDER_SYMBOL(\"{}\");\n\n",
      function.name, parametersText(function.parameters), inC(function.result),
      rangeText(function.lowest, function.highest), function.name,
      types.empty() ? "void" : fmt::to_string(fmt::join(types, ", ")), function.symbol);
}

void add(std::string& text, const Sensor& sensor) {
  text += fmt::format(
      "/* {}: a new reading, {}{}; NaN if there is none since the last.\n"
      "   Asked once a tick, with the mission time, s. For gliderRead: sensor_{}_id. */\n"
      "double sensor_{}(double) GLIDER_SYMBOL(\"{}\");\n"
      "enum {{ sensor_{}_id = {} }};\n\n",
      sensor.name, inC(sensor.type), rangeText(sensor.lowest, sensor.highest), sensor.name,
      sensor.name, sensor.symbol, sensor.name, sensor.id);
}

void add(std::string& text, const Behaviour& behaviour) {
  const bool profile = behaviour.kind == BehaviourKind::Profile;
  std::string types;
  for (size_t i = 0; i < behaviour.parameters.size(); ++i) {
    types += ", double";
  }
  text += fmt::format(
      "/* flight{} {}{}. */\n"
      "void {}_{}(GliderContext*, GliderBehaviourMemory*, uint32_t{})\n"
      "    GLIDER_SYMBOL(\"{}\");\n\n",
      profile ? "profile" : "route", behaviour.name, parametersText(behaviour.parameters),
      profile ? "profile" : "route", behaviour.name, types, behaviour.symbol);
}

}  // namespace

std::string printHeader(const CInterface& in_c, std::string_view name) {
  std::string text = fmt::format(
      "/* What mission {} has in C and C++. Made by `glidercc build --emit header`; make it again\n"
      "   when the mission's declarations change. Every number is a double, NaN if unknown. */\n"
      "#pragma once\n\n"
      "#include \"runtime/abi/behaviour.h\"\n\n"
      "#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n",
      name);
  for (const Function& function : in_c.functions) {
    add(text, function);
  }
  for (const Sensor& sensor : in_c.sensors) {
    add(text, sensor);
  }
  for (const Behaviour& behaviour : in_c.behaviours) {
    add(text, behaviour);
  }
  return text + "#ifdef __cplusplus\n}\n#endif\n";
}

}  // namespace glider::ir
