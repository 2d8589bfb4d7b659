// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/bare_positions.h"
#include "frontend/sema/expressions/literals.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::frontend {

namespace {

/// `value` of a unit in SI units: 70 cm is the double nearest to 0.7 m, as `0.7 m` is. A hundredth
/// is not a double, but a hundred is.
double inSi(double value, double to_si) {
  const double parts = std::round(1 / to_si);
  return parts > 1 && 1 / parts == to_si ? value / parts : value * to_si;
}

constexpr ir::Type kLatitude{ir::TypeKind::Latitude, {}};
constexpr ir::Type kLongitude{ir::TypeKind::Longitude, {}};

/// What a number with this unit counts; nothing for a percentage or for a unit with a dimension.
Scale scaleOf(std::string_view unit) {
  const auto known = support::findUnit(unit);
  return known && known->dimension.dimensionless() && unit != "%" ? Scale{known->spelling, true}
                                                                  : Scale{};
}

/// The degrees of a magnetic heading, from 0 to below 360.
double inTurn(const ast::Literal& node, bool negative) {
  constexpr double kTurn = 360;
  const double degrees = std::fmod(parseNumber(node.digits).value_or(0), kTurn);
  return negative && degrees > 0 ? kTurn - degrees : degrees;
}

bool isLetter(const std::string& unit) {
  return unit == "N" || unit == "S" || unit == "E" || unit == "W";
}

}  // namespace

bool isMagneticUnit(std::string_view unit) {
  return unit.ends_with(" magnetic");
}

ExprLowering::Result ExprLowering::refuseMagnetic(const ast::Literal& node,
                                                  const support::SourceRange& range) {
  const bool negative = scope_.text(range).starts_with('-');
  const std::string better = node.unit.starts_with("deg")
                                 ? fmt::format("`{:.10g} deg magnetic`", inTurn(node, negative))
                                 : "an angle from 0 deg to below 360 deg";
  scope_.report(support::diagnostics::magneticHeading, range, scope_.text(range), better);
  return std::nullopt;
}

bool takesUnitOfContext(const ast::Expr& expr) {
  if (const auto* literal = std::get_if<ast::Literal>(&expr.node)) {
    return literal->unit.empty() || literal->unit == "W" || literal->unit == "S";
  }
  if (const auto* unary = std::get_if<ast::Unary>(&expr.node)) {
    return unary->op == ast::UnaryOp::Negate && takesUnitOfContext(*unary->operand);
  }
  if (const auto* binary = std::get_if<ast::Binary>(&expr.node)) {
    const bool adds = binary->op == ast::BinaryOp::Add || binary->op == ast::BinaryOp::Subtract;
    return adds && takesUnitOfContext(*binary->left) && takesUnitOfContext(*binary->right);
  }
  return false;
}

std::optional<double> ExprLowering::number(const ast::Literal& node,
                                           const support::SourceRange& range) {
  const std::optional<double> value = parseNumber(node.digits);
  if (!value) {
    scope_.report(support::diagnostics::numberTooLarge, range, node.digits);
  }
  return value;
}

ExprLowering::Result ExprLowering::visit(const ast::Literal& node, const ast::Expr& expr,
                                         std::optional<ir::Type> want) {
  if (node.unit.empty()) {
    return bareLiteral(node, expr.where, want, false);
  }
  if (isLetter(node.unit)) {
    return letterLiteral(node, expr.where, want);
  }
  const std::optional<double> value = number(node, expr.where);
  if (!value) {
    return std::nullopt;
  }
  const bool magnetic = isMagneticUnit(node.unit);
  const std::string written = magnetic ? node.unit.substr(0, node.unit.find(' ')) : node.unit;
  const auto unit = support::parseUnit(written);
  if (!unit) {
    refuseUnit(node, want);
    return std::nullopt;
  }
  const double si = inSi(*value, unit->to_si);
  if (!std::isfinite(si)) {
    scope_.report(support::diagnostics::numberTooLarge, expr.where, scope_.text(expr.where));
    return std::nullopt;
  }
  Value result = emitNumber(si, quantity(unit->dimension), expr.where);
  if (magnetic) {
    return si < kFullTurn ? fromMagnetic(result.id, expr.where) : refuseMagnetic(node, expr.where);
  }
  result.scale = scaleOf(node.unit);
  return result;
}

void ExprLowering::refuseUnit(const ast::Literal& node, std::optional<ir::Type> want) {
  if (unitForWord(node.unit) != "deg") {
    scope_.report(support::diagnostics::unknownUnit, node.unit_where, node.unit,
                  "combine units with `*` and `/`, as in `degC/m`");
    return;
  }
  const bool angle = want && want->dimension == support::dimension::angle;
  const bool temperature = want && want->dimension == support::dimension::temperature;
  if (!angle && !temperature) {
    scope_.report(support::diagnostics::unknownUnit, node.unit_where, node.unit,
                  "write `deg` for an angle, `degC` for a temperature");
    return;
  }
  const std::string unit = angle ? "deg" : "degC";
  scope_
      .report(support::diagnostics::unknownUnit, node.unit_where, node.unit,
              fmt::format("write `{}`", unit))
      .fix(node.unit_where, unit);
}

ExprLowering::Result ExprLowering::bareLiteral(const ast::Literal& node,
                                               const support::SourceRange& range,
                                               std::optional<ir::Type> want, bool negative) {
  if (node.digits.find_first_of(" \t\r\n,") != std::string::npos) {
    return std::nullopt;  // `3355.2 1825.4`, which the parser has refused
  }
  if (want && (want->kind == ir::TypeKind::Latitude || want->kind == ir::TypeKind::Longitude)) {
    return barePosition(node, range, *want, negative);
  }
  const std::optional<double> value = number(node, range);
  if (!value) {
    return std::nullopt;
  }
  const ir::Type type = want && want->kind == ir::TypeKind::Quantity ? *want : plainNumber();
  const auto unit = support::bareUnit(type.dimension);
  if (!unit) {
    scope_.report(support::diagnostics::needsUnit, range, scope_.text(range),
                  support::unitName(type.dimension));
    return std::nullopt;
  }
  const double si = inSi(*value, unit->to_si);
  if (!std::isfinite(si)) {
    scope_.report(support::diagnostics::numberTooLarge, range, node.digits);
    return std::nullopt;
  }
  if (type.dimension == support::dimension::angle) {
    checkBareAngle(node, range, si, negative);
  }
  if (type.dimension == support::dimension::energy) {
    checkBareEnergy(node, range, si);
  }
  return emitNumber(negative ? -si : si, type, range);
}

/// A number without a unit is in radians: few mean it so.
void ExprLowering::checkBareAngle(const ast::Literal& node, const support::SourceRange& range,
                                  double si, bool negative) {
  const std::string text = (negative ? "-" : "") + node.digits;
  const std::string after = scope_.wordAfter(range);
  if (!unitForWord(after).empty() || after == "magnetic") {
    return;  // `26 degrees` has been reported
  }
  // What has two digits after the point may have been computed: `1.57`.
  const size_t point = std::min(node.digits.find('.'), node.digits.size());
  constexpr size_t kOneDigit = 2;  // with the point
  if (si > kFullTurn) {
    scope_.report(support::diagnostics::bareAngle, range, text).fix(range, text + " deg");
  } else if (si >= 1 && node.digits.size() - point <= kOneDigit) {
    constexpr double kHalfTurn_deg = 180;
    const double degrees = si / std::numbers::pi * kHalfTurn_deg;
    scope_.report(support::diagnostics::bareRadians, range, text,
                  fmt::format("{:.0f}", negative ? -degrees : degrees));
  }
}

/// A number without a unit is in joules: a small one is meant in watt hours.
void ExprLowering::checkBareEnergy(const ast::Literal& node, const support::SourceRange& range,
                                   double si) {
  constexpr double kWattHour_J = 3600, kLeastMeant_J = 10 * kWattHour_J;
  if (si > 0 && si < kLeastMeant_J && unitForWord(scope_.wordAfter(range)).empty()) {
    scope_.report(support::diagnostics::bareEnergy, range, node.digits,
                  fmt::format("{:.3g}", si / kWattHour_J));
  }
}

ExprLowering::Result ExprLowering::barePosition(const ast::Literal& node,
                                                const support::SourceRange& range, ir::Type want,
                                                bool negative) {
  const auto parts = parseDegreesMinutes(node.digits);
  if (!parts) {
    scope_.report(support::diagnostics::numberTooLarge, range, node.digits);
    return std::nullopt;
  }
  const bool latitude = want.kind == ir::TypeKind::Latitude;
  const std::string text = scope_.text(range);
  const char letter = latitude ? (negative ? 'S' : 'N') : (negative ? 'W' : 'E');
  const std::string better = fmt::format("{} {}", node.digits, letter);
  const bool decimal = !isPlainlyDdmm(node.digits);
  if (parts->minutes >= 60) {
    auto report = scope_.report(support::diagnostics::minutesOver60, range, text, parts->degrees,
                                parts->minutes);
    if (decimal && negative) {
      report.hint(fmt::format("write decimal degrees with a letter: `{}`", better))
          .fix(range, better);
    } else if (decimal) {  // no fix: only the pilot knows on which side a letter was lost
      report.hint(fmt::format("write decimal degrees with a letter: `{}` or `{} {}`", better,
                              node.digits, latitude ? 'S' : 'W'));
    }
    return std::nullopt;
  }
  const double degrees = negative ? -parts->value() : parts->value();
  if (!checkOnEarth(range, latitude, degrees)) {
    return std::nullopt;
  }
  if (decimal) {  // no fix: near the equator it may be minutes
    const size_t whole = std::min(node.digits.find_first_not_of("0123456789"), node.digits.size());
    scope_.report(support::diagnostics::decimalPosition, range, text, node.digits, better,
                  (negative ? "-" : "") + std::string(4 - whole, '0') + node.digits);
    return std::nullopt;
  }
  return emitNumber(degrees, want, range);
}

bool ExprLowering::checkOnEarth(const support::SourceRange& range, bool latitude, double degrees) {
  const double greatest = latitude ? 90 : 180;
  if (std::fabs(degrees) <= greatest) {
    return true;
  }
  scope_.report(support::diagnostics::notOnEarth, range, scope_.text(range),
                latitude ? "latitude" : "longitude", std::fabs(degrees), greatest);
  return false;
}

ExprLowering::Result ExprLowering::letterLiteral(const ast::Literal& node,
                                                 const support::SourceRange& range,
                                                 std::optional<ir::Type> want) {
  const bool earth =
      want && (want->kind == ir::TypeKind::Latitude || want->kind == ir::TypeKind::Longitude);
  if (node.unit == "N" || node.unit == "E") {
    return compass(node, range, node.unit == "N", 1);
  }
  if (earth) {
    return compass(node, range, node.unit == "S", -1);
  }
  if (node.unit == "W" && want && want->kind == ir::TypeKind::Quantity) {
    const std::optional<double> value = number(node, range);
    return value ? Result(emitNumber(*value, quantity(support::dimension::power), range))
                 : std::nullopt;
  }
  const bool watt = node.unit == "W";
  scope_.report(support::diagnostics::ambiguousLetter, range, scope_.text(range),
                watt ? "watts or west" : "south or siemens",
                watt ? "give it a type, as in `const x: power = 5 W`, or write a whole "
                       "position, as in `39.2 N 73.9 W`"
                     : "write a conductivity in `S/m`, or give a latitude its type, as in `const "
                       "x: latitude = 33.9 S`");
  return std::nullopt;
}

ExprLowering::Result ExprLowering::compass(const ast::Literal& node,
                                           const support::SourceRange& range, bool latitude,
                                           double sign) {
  const std::optional<DegreesMinutes> parts = parseLettered(node.digits);
  if (!parts) {
    scope_.report(support::diagnostics::numberTooLarge, range, node.digits);
    return std::nullopt;
  }
  if (parts->minutes >= 60) {
    scope_
        .report(support::diagnostics::minutesOver60, range, scope_.text(range), parts->degrees,
                parts->minutes)
        .hint(
            "four digits or more before the point are ddmm.mmmm; decimal degrees have at most "
            "three");
    return std::nullopt;
  }
  if (!checkOnEarth(range, latitude, parts->value())) {
    return std::nullopt;
  }
  return emitNumber(sign * parts->value(), latitude ? kLatitude : kLongitude, range);
}

ExprLowering::Result ExprLowering::visit(const ast::Position& node, const ast::Expr&,
                                         std::optional<ir::Type>) {
  const ast::Literal& latitude = node.latitude;
  const ast::Literal& longitude = node.longitude;
  const auto& latitude_where = node.latitude_where;
  const auto& longitude_where = node.longitude_where;
  if (longitudeFirst({latitude, latitude_where}, {longitude, longitude_where}, " ")) {
    return std::nullopt;
  }
  Result first;
  Result second;
  if (isLetter(latitude.unit)) {
    first = letterLiteral(latitude, latitude_where, kLatitude);
  }
  if (isLetter(longitude.unit)) {
    second = letterLiteral(longitude, longitude_where, kLongitude);
  }
  auto check = [&](const Result& half, const ir::Type& type, const support::SourceRange& where,
                   const char* letters) {
    if (half && half->type != type) {
      scope_.report(support::diagnostics::wrongType, where, "this half of the position",
                    describe(type), scope_.text(where),
                    fmt::format("{} ({})", describe(half->type), letters), howToWrite({type}));
      return false;
    }
    return half.has_value();
  };
  if (!isLetter(node.latitude.unit)) {
    scope_.report(support::diagnostics::unknownUnit, node.latitude_where,
                  scope_.text(node.latitude_where), "write a position such as `39.2 N 73.9 W`");
    return std::nullopt;
  }
  if (!check(first, kLatitude, latitude_where, "`E` and `W`") ||
      !check(second, kLongitude, longitude_where, "`N` and `S`")) {
    return std::nullopt;
  }
  first->longitude = second->id;
  return first;
}

}  // namespace glider::frontend
