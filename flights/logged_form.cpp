// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/logged_form.h"

#include "support/units/position_text.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace glider::flights {
namespace {

using Half = LoggedForm::Half;

std::string shownNumber(double value, const std::string& unit) {
  constexpr double kLarge = 1e5;  // from here on five digits would need an exponent
  constexpr std::string_view kUnnamed[] = {"", "nodim", "enum"};
  if (unit == "bool") {
    return value != 0 ? "true" : "false";
  }
  if (unit == "rad") {
    constexpr double kDegrees = 180 / std::numbers::pi;
    return fmt::format("{:.1f} deg", value * kDegrees);
  }
  const std::string number = unit == "deg"                ? fmt::format("{:.5f}", value)
                             : std::fabs(value) >= kLarge ? fmt::format("{:.0f}", value)
                                                          : fmt::format("{:.5g}", value);
  return std::ranges::find(kUnnamed, unit) == std::end(kUnnamed) ? number + " " + unit : number;
}

std::string shownValue(const LoggedForm& form, double value) {
  if (std::isnan(value)) {
    return "unknown";
  }
  switch (form.half) {
    case Half::Latitude:
      return support::latitudeText(value);
    case Half::Longitude:
      return support::longitudeText(value);
    case Half::None:
      break;
  }
  return shownNumber(value, form.unit);
}

/// Whether the value after `values[i]` is the longitude of the same position.
bool isPosition(std::span<const LoggedForm> forms, std::span<const double> values, size_t i) {
  return i + 1 < values.size() && forms[i].half == Half::Latitude &&
         forms[i + 1].half == Half::Longitude && !std::isnan(values[i]) &&
         !std::isnan(values[i + 1]);
}

}  // namespace

LoggedForm formOf(const ir::Type& type) {
  switch (type.kind) {
    case ir::TypeKind::Bool:
      return {"bool", 1, Half::None};
    case ir::TypeKind::Latitude:
      return {"deg", 1, Half::Latitude};
    case ir::TypeKind::Longitude:
      return {"deg", 1, Half::Longitude};
    case ir::TypeKind::Quantity:
      break;
  }
  const std::string name = support::unitName(type.dimension);
  const auto unit = support::parseUnit(name);
  return {name, unit ? 1 / unit->to_si : 1, Half::None};
}

LoggedForm formOf(const ir::Sensor& sensor, const SensorUnit& unit) {
  const bool plain =
      sensor.type.kind == ir::TypeKind::Quantity && sensor.type.dimension.dimensionless();
  const std::string its = plain ? unit(sensor.vehicle_name) : "";
  return its.empty() ? formOf(sensor.type) : LoggedForm{its, 1, Half::None};
}

LoggedForm formOf(const ir::Mission& mission, ir::ExprId id, const SensorUnit& unit) {
  const ir::Expr& e = mission[id];
  const ir::Expr& read = e.op == ir::Op::Temporal ? mission[mission[e.temporal].operand] : e;
  const bool bare = read.op == ir::Op::Sensor && read.type == e.type;
  return bare ? formOf(mission[read.sensor], unit) : formOf(e.type);
}

std::string shownValues(std::span<const LoggedForm> forms, std::span<const double> values) {
  std::string list;
  for (size_t i = 0; i < values.size(); ++i) {
    list += i == 0 ? "" : ", ";
    if (isPosition(forms, values, i)) {
      list += support::positionText(values[i], values[i + 1]);
      ++i;
    } else {
      list += shownValue(forms[i], values[i]);
    }
  }
  return list;
}

}  // namespace glider::flights
