// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/parameter_rows.h"

#include "flights/parameter_table.h"
#include "runtime/launch/launch.h"
#include "support/units/position_text.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace glider::analysis {
namespace {

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

/// The unit of the default in the mission's text, "km" of `5 km`; none: write what the launcher
/// does, as for times, of which it chooses the unit.
std::optional<support::Unit> writtenUnit(const compiler::Optimised& mission,
                                         const ir::Variable& variable) {
  constexpr support::Dimension kTime = support::dimension::time;
  const support::SourceRange range = mission.mission[variable.initial].range;
  if (variable.type.kind != ir::TypeKind::Quantity || variable.type.dimension == kTime ||
      !range.valid()) {
    return std::nullopt;
  }
  const std::string_view text = mission.checked->sources().text(range);
  const auto unit = support::parseUnit(text.substr(text.find_last_of(' ') + 1));
  return unit && unit->dimension == variable.type.dimension ? unit : std::nullopt;
}

/// Whether the default is a time of several parts, `3 h 30 min`.
bool isInParts(const compiler::Optimised& mission, const ir::Variable& variable) {
  const support::SourceRange range = mission.mission[variable.initial].range;
  if (variable.type.kind != ir::TypeKind::Quantity ||
      variable.type.dimension != support::dimension::time || !range.valid()) {
    return false;
  }
  const std::string_view text = mission.checked->sources().text(range);
  const size_t letter = text.find_first_of("dhms");
  return letter != text.npos && text.find_first_of("0123456789", letter) != text.npos &&
         text.find('T') == text.npos;
}

/// "3 h 30 min".
std::string inParts(double seconds) {
  std::string text;
  double rest = seconds;
  for (const auto& [name, size] : {std::pair("day", 86400.0), std::pair("h", 3600.0),
                                   std::pair("min", 60.0), std::pair("s", 1.0)}) {
    const double count = size == 1 ? rest : std::floor(rest / size);
    rest -= count * size;
    if (count > 0) {
      text += fmt::format("{}{:.10g} {}", text.empty() ? "" : " ", count, name);
    }
  }
  return text;
}

/// The values of a parameter as they are shown.
class Shown {
 public:
  Shown(const GliderParameterInfo& info, const std::optional<support::Unit>& unit,
        ir::TypeKind kind, bool parts)
      : info_(info), unit_(unit), kind_(kind), parts_(parts) {}

  [[nodiscard]] std::string value(double of) const {
    switch (kind_) {
      case ir::TypeKind::Latitude:
        return support::latitudeText(of);
      case ir::TypeKind::Longitude:
        return support::longitudeText(of);
      case ir::TypeKind::Bool:
      case ir::TypeKind::Quantity:
        break;
    }
    if (parts_ && of > 0) {
      return inParts(of);
    }
    return unit_ ? fmt::format("{:.10g} {}", of / unit_->to_si, unit_->spelling)
                 : written([&](runtime::Text& text) { runtime::writeQuantity(info_, of, text); });
  }
  [[nodiscard]] std::string range() const {
    if (!(unit_ || parts_) || !std::isfinite(info_.lowest) || !std::isfinite(info_.highest)) {
      return written([&](runtime::Text& text) { runtime::writeRange(info_, text); });
    }
    return value(info_.lowest) + " to " + value(info_.highest);
  }

 private:
  const GliderParameterInfo& info_;
  const std::optional<support::Unit>& unit_;
  ir::TypeKind kind_;
  bool parts_;
};

ParameterRow rowOf(const compiler::Optimised& mission, const ir::Variable& variable,
                   const GliderParameterInfo& info, double value) {
  const std::optional<support::Unit> unit = writtenUnit(mission, variable);
  const Shown shown(info, unit, variable.type.kind, isInParts(mission, variable));
  return {variable.name, typeName(variable.type), shown.value(info.initial), shown.range(),
          value == info.initial ? "" : shown.value(value)};
}

/// The row of a position. Every position on Earth is in its range.
ParameterRow together(std::string name, const ParameterRow& latitude,
                      const ParameterRow& longitude) {
  const auto set = [](const ParameterRow& half) {
    return half.set_to.empty() ? half.initial : half.set_to;
  };
  const bool both_default = latitude.set_to.empty() && longitude.set_to.empty();
  return {std::move(name), "position", latitude.initial + " " + longitude.initial, "",
          both_default ? "" : set(latitude) + " " + set(longitude)};
}

}  // namespace

support::Result<std::vector<ParameterRow>> parameterRows(const compiler::Optimised& mission,
                                                         const flights::LaunchChoice& choice) {
  const flights::ParameterTable table(mission.mission);
  const auto values = flights::chooseParameters(mission.mission, choice);
  if (!values) {
    return std::unexpected(values.error());
  }
  std::vector<ParameterRow> rows;
  for (size_t i = 0; i < values->size(); ++i) {
    const runtime::Piece position = runtime::positionOf(table.mission(), static_cast<uint32_t>(i));
    rows.push_back(rowOf(mission, mission.mission.variables[i], table[i], values->at(i)));
    if (!position.empty()) {
      ++i;
      rows.back() = together({position.begin, position.end}, rows.back(),
                             rowOf(mission, mission.mission.variables[i], table[i], values->at(i)));
    }
  }
  return rows;
}

}  // namespace glider::analysis
