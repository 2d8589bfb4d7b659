// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/logged_form.h"

#include "support/units/duration_text.h"
#include "support/units/position_text.h"
#include "support/units/units.h"
#include "support/utc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace glider::flights {
namespace {

using Half = LoggedForm::Half;

bool isUnnamed(std::string_view unit) {
  constexpr std::string_view kUnnamed[] = {"", "1", "nodim", "enum"};
  return std::ranges::find(kUnnamed, unit) != std::end(kUnnamed);
}

/// `value` with so many digits after the point; what is 0 then has no sign.
std::string fixed(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  return zero && text.starts_with('-') ? text.substr(1) : text;
}

/// In degrees. A heading of almost a whole turn is shown as 0 deg, which it is nearer to.
std::string shownAngle(double radians) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const std::string degrees = fixed(radians / kTurn * 360, 1);
  return (degrees == "360.0" && radians < kTurn ? "0.0" : degrees) + " deg";
}

std::string shownNumber(double value, const std::string& unit) {
  constexpr double kThousand = 1e3;  // densities differ in the sixth digit
  constexpr double kLarge = 1e5;     // from here on five digits would need an exponent
  constexpr double kHuge = 1e15;     // from here on not all digits are known
  if (unit == "bool") {
    return value != 0 ? "true" : "false";
  }
  if (unit == "rad") {
    return shownAngle(value);
  }
  if (unit == "timestamp") {
    return support::instantText(value);
  }
  if (unit == "s") {
    return support::durationText(value);
  }
  const double size = std::fabs(value);
  const std::string number = unit == "deg" ? fixed(value, 5)
                             : size >= kLarge && size < kHuge
                                 ? fmt::format("{:.0f}", value)
                                 : fmt::format("{:.{}g}", value + 0.0, size >= kThousand ? 7 : 5);
  return isUnnamed(unit) ? number : number + " " + unit;
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
  const bool quantity = sensor.type.kind == ir::TypeKind::Quantity;
  const bool plain = quantity && sensor.type.dimension.dimensionless();
  const bool time = quantity && sensor.type.dimension == support::dimension::time;
  std::string its = plain || time ? unit(sensor.vehicle_name) : "";
  its = time && its != "timestamp" ? "" : its;
  return its.empty() ? formOf(sensor.type) : LoggedForm{its, 1, Half::None};
}

LoggedForm formOf(const ir::Mission& mission, ir::ExprId id, const SensorUnit& unit) {
  const ir::Expr& e = mission[id];
  const ir::Expr& read = e.op == ir::Op::Temporal ? mission[mission[e.temporal].operand] : e;
  const bool bare = read.op == ir::Op::Sensor && read.type == e.type;
  return bare ? formOf(mission[read.sensor], unit) : formOf(e.type);
}

SensorUnit unitsOf(const platforms::Platform& platform) {
  return [&platform](const std::string& sensor) -> std::string {
    const platforms::PlatformSensor* const known = platform.find(sensor);
    return known != nullptr ? known->unit : "";
  };
}

void forEachLog(const ir::Mission& mission,
                const std::function<void(const ir::Statement&)>& visit) {
  for (const ir::Block& block : mission.blocks) {
    for (const ir::Statement& statement : block.statements) {
      if (statement.kind == ir::StatementKind::Log) {
        visit(statement);
      }
    }
  }
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

std::string exactValue(const LoggedForm& form, double value) {
  constexpr int kDigits = 12;
  if (std::isnan(value)) {
    return "unknown";
  }
  const std::string_view unit = form.unit == "timestamp" ? std::string_view("s") : form.unit;
  const bool bare = unit == "bool" || isUnnamed(unit);
  return fmt::format("{:.{}g}{}{}", value, kDigits, bare ? "" : " ", bare ? "" : unit);
}

}  // namespace glider::flights
