// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/value_text.h"

#include "support/units/position_text.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace glider::ir {
namespace {

std::string unitOf(Type type) {
  return type.kind == TypeKind::Quantity ? support::unitName(type.dimension) : "deg";
}

/// Converts from SI units (positions: degrees) to the unit that is shown.
double shown(double value, Type type) {
  const auto unit = type.kind == TypeKind::Quantity ? support::bareUnit(type.dimension)
                                                    : std::optional<support::Unit>();
  return unit ? value / unit->to_si : value;
}

}  // namespace

std::string withUnit(double value, Type type) {
  if (type.kind == TypeKind::Latitude && std::isfinite(value)) {
    return support::latitudeText(value);
  }
  if (type.kind == TypeKind::Longitude && std::isfinite(value)) {
    return support::longitudeText(value);
  }
  if (type.kind == TypeKind::Quantity && type.dimension == support::dimension::angle) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    return fmt::format("{:.6g} deg", value * kDegrees);
  }
  const std::string unit = unitOf(type);
  return fmt::format("{:.6g}{}{}", shown(value, type), unit.empty() ? "" : " ", unit);
}

std::string withCountedUnit(double value, Type type, std::string_view unit) {
  const auto counted = support::findUnit(unit);
  const bool number = type.kind == TypeKind::Quantity && type.dimension.dimensionless();
  return number && counted && counted->dimension.dimensionless()
             ? fmt::format("{:.6g} {}", value / counted->to_si, unit)
             : withUnit(value, type);
}

std::string withUnit(double value, const Variable& variable) {
  if (variable.type.kind == TypeKind::Bool) {
    return value != 0 ? "true" : "false";
  }
  return withCountedUnit(value, variable.type, variable.unit);
}

std::string withUnitExactly(double value, Type type) {
  constexpr int kMostDigits = 15;  // that a launch accepts
  if (type.kind == TypeKind::Latitude || type.kind == TypeKind::Longitude) {
    const bool latitude = type.kind == TypeKind::Latitude;
    const char letter = value < 0 ? (latitude ? 'S' : 'W') : (latitude ? 'N' : 'E');
    return fmt::format("{:.{}g} {}", std::fabs(value), kMostDigits, letter);
  }
  return fmt::format("{:.{}g}{}", shown(value, type), kMostDigits,
                     type.kind == TypeKind::Quantity ? unitOf(type) : "");
}

std::string rangeText(const Variable& variable) {
  if (variable.lowest == -Variable::kEndless) {
    return fmt::format("at most {}", withUnit(variable.highest, variable.type));
  }
  if (variable.highest == Variable::kEndless) {
    return fmt::format("at least {}", withUnit(variable.lowest, variable.type));
  }
  return fmt::format("{} .. {}", withUnit(variable.lowest, variable.type),
                     withUnit(variable.highest, variable.type));
}

}  // namespace glider::ir
