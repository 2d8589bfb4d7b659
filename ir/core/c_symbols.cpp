// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/c_symbols.h"

#include "ir/core/type_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace glider::ir {
namespace {

constexpr std::string_view kBaseUnits[] = {"m", "kg", "s", "A", "K", "rad"};

/// "temperature"; "m1s_2" for a dimension without a name.
std::string typeWord(const Type& type) {
  if (auto name = typeName(type)) {
    return std::move(*name);
  }
  std::string word;
  for (size_t i = 0; i < type.dimension.exponents.size(); ++i) {
    const int exponent = type.dimension.exponents.at(i);
    if (exponent != 0) {
      word += fmt::format("{}{}{}", kBaseUnits[i], exponent < 0 ? "_" : "",
                          exponent < 0 ? -exponent : exponent);
    }
  }
  return word;
}

/// Takes "s_2" from the front of a word that `typeWord` made; false if the word does not begin with
/// a power.
bool takePower(std::string_view& word, support::Dimension& dimension) {
  const size_t unit_end = std::min(word.find_first_of("_0123456789"), word.size());
  const auto* unit = std::ranges::find(kBaseUnits, word.substr(0, unit_end));
  word.remove_prefix(unit_end);
  const bool negative = word.starts_with('_');
  word.remove_prefix(negative ? 1 : 0);
  int exponent = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), exponent);
  constexpr int kLargest = 12;
  if (unit == std::end(kBaseUnits) || error != std::errc() || exponent > kLargest) {
    return false;
  }
  word.remove_prefix(static_cast<size_t>(end - word.data()));
  dimension.exponents.at(static_cast<size_t>(unit - kBaseUnits)) =
      static_cast<int8_t>(negative ? -exponent : exponent);
  return true;
}

/// The word of `typeWord` for a dimension without a name as a unit, "m/s^2"; other words unchanged.
std::string unitOfWord(std::string_view word) {
  support::Dimension dimension;
  std::string_view rest = word;
  while (!rest.empty()) {
    if (!takePower(rest, dimension)) {
      return std::string(word);
    }
  }
  return support::unitName(dimension);
}

std::vector<std::string> typeWords(const std::vector<Parameter>& parameters) {
  std::vector<std::string> words;
  for (const Parameter& parameter : parameters) {
    words.push_back(typeWord(parameter.type));
  }
  return words;
}

std::string symbol(std::string_view kind, std::string_view name,
                   const std::vector<std::string>& words) {
  return fmt::format("glider.{}.{}{}{}", kind, name, words.empty() ? "" : ".",
                     fmt::join(words, "."));
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const size_t dot = text.find('.');
    parts.push_back(text.substr(0, dot));
    if (dot == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(dot + 1);
  }
}

std::string listed(const std::vector<std::string>& types) {
  return types.empty() ? "" : fmt::format("({})", fmt::join(types, ", "));
}

}  // namespace

std::string functionSymbol(std::string_view name, const std::vector<Parameter>& parameters,
                           const Type& result) {
  auto words = typeWords(parameters);
  words.push_back(typeWord(result));
  return symbol("function", name, words);
}

std::string sensorSymbol(std::string_view name, const Type& type) {
  return symbol("sensor", name, {typeWord(type)});
}

std::string behaviourSymbol(BehaviourKind kind, std::string_view name,
                            const std::vector<Parameter>& parameters,
                            const std::vector<OwnRead>& own) {
  auto words = typeWords(parameters);
  if (!own.empty()) {
    words.emplace_back("reads");
  }
  for (const OwnRead& sensor : own) {
    words.emplace_back(sensor.name);
    words.push_back(std::to_string(sensor.id - kFirstOwnSensor));
  }
  return symbol(kind == BehaviourKind::Profile ? "profile" : "route", name, words);
}

CInterface usedInC(const Mission& mission) {
  CInterface result{mission.functions, {}, {}};
  std::ranges::copy_if(mission.sensors, std::back_inserter(result.sensors),
                       [](const Sensor& sensor) { return !sensor.symbol.empty(); });
  for (const Behaviour& behaviour : mission.behaviours) {
    if (!behaviour.symbol.empty()) {
      result.behaviours.push_back(behaviour);
      result.behaviours.back().reads.clear();
    }
  }
  return result;
}

std::optional<CSymbol> readSymbol(std::string_view symbol) {
  const auto parts = split(symbol);
  constexpr std::array<std::string_view, 4> kKinds = {"function", "sensor", "profile", "route"};
  if (parts.size() < 3 || parts[0] != "glider" ||
      std::ranges::find(kKinds, parts[1]) == kKinds.end()) {
    return std::nullopt;
  }
  CSymbol result{std::string(parts[1]), std::string(parts[2]), ""};
  const bool behaviour = parts[1] == "profile" || parts[1] == "route";
  const auto reads = behaviour ? std::ranges::find(parts, "reads") : parts.end();
  std::vector<std::string> types;
  for (auto part = parts.begin() + 3; part < reads; ++part) {
    types.push_back(unitOfWord(*part));
  }
  if (behaviour) {
    std::vector<std::string_view> sensors;
    for (auto part = reads; parts.end() - part > 2; part += 2) {
      sensors.push_back(*(part + 1));
    }
    result.declaration = fmt::format("flight{} {}{}{}{}", parts[1], parts[2], listed(types),
                                     sensors.empty() ? "" : " reads ", fmt::join(sensors, ", "));
    return result;
  }
  if (types.empty()) {
    return std::nullopt;
  }
  const std::string last = types.back();
  types.pop_back();
  const std::string parameters = parts[1] == "function" && types.empty() ? "()" : listed(types);
  result.declaration = fmt::format("{} {}{}: {}", parts[1], parts[2], parameters, last);
  return result;
}

}  // namespace glider::ir
