// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/bare_positions.h"
#include "frontend/sema/expressions/literals.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::frontend {

namespace {

/// Half of a position as it is written: a number, possibly with a minus or a letter.
struct Half {
  const ast::Literal* literal = nullptr;
  bool negative = false;

  [[nodiscard]] bool bare() const { return literal->unit.empty(); }
  [[nodiscard]] bool north() const { return literal->unit == "N" || literal->unit == "S"; }
  [[nodiscard]] bool east() const { return literal->unit == "E" || literal->unit == "W"; }
  [[nodiscard]] std::string text() const {
    return (negative ? "-" : "") + literal->digits + (bare() ? "" : " " + literal->unit);
  }
  /// The same number with `letter`.
  [[nodiscard]] std::string with(std::string_view letter) const {
    return fmt::format("{} {}", literal->digits, letter);
  }
  [[nodiscard]] double degrees() const {
    const auto parts =
        bare() ? parseDegreesMinutes(literal->digits) : parseLettered(literal->digits);
    const double value = parts ? parts->value() : NAN;
    return negative ? -value : value;
  }
};

std::optional<Half> halfOf(const ast::Expr& expr) {
  if (const auto* literal = std::get_if<ast::Literal>(&expr.node)) {
    return Half{literal, false};
  }
  const auto* unary = std::get_if<ast::Unary>(&expr.node);
  if (unary == nullptr || unary->op != ast::UnaryOp::Negate) {
    return std::nullopt;
  }
  const auto* literal = std::get_if<ast::Literal>(&unary->operand->node);
  return literal == nullptr ? std::nullopt : std::optional(Half{literal, true});
}

bool isSwapped(const Half& first, const Half& second) {
  if (first.bare() && second.bare()) {
    return isLongitudeFirst(first.degrees(), second.degrees());
  }
  return (first.east() && (second.bare() || second.north())) ||
         (second.north() && (first.bare() || first.east()));
}

/// The other possible meaning, if the first number can be a latitude.
std::string otherwise(const Half& first, const Half& second, std::string_view between) {
  constexpr double kMostLatitude = 90;
  if (!(std::fabs(first.degrees()) <= kMostLatitude)) {
    return "";
  }
  if (first.bare() && second.bare()) {
    return fmt::format("; if it is a latitude, give it a letter: `{}{}{}`",
                       withLetter(first.degrees(), true), between,
                       withLetter(second.degrees(), false));
  }
  if (first.east() && second.north()) {
    return fmt::format("; if the letters are swapped, `{}{}{}`", first.with(second.literal->unit),
                       between, second.with(first.literal->unit));
  }
  return "";
}

/// Whether the numbers are in order, so that the letters are more probably wrong: few gliders fly
/// beyond 70 degrees.
bool areLettersSwapped(const Half& first, const Half& second) {
  return first.east() && second.north() && isLongitudeFirst(second.degrees(), first.degrees());
}

/// Whether it is a number without a letter that is not plainly ddmm.mmmm.
bool mayBeDegrees(const Half& half) {
  return half.bare() && !isPlainlyDdmm(half.literal->digits);
}

}  // namespace

bool ExprLowering::decimalDegrees(const ast::Expr& first, const ast::Expr& second) {
  constexpr double kMinutes = 60;
  const auto one = halfOf(first);
  const auto two = halfOf(second);
  if (!one || !two || !mayBeDegrees(*one) || !mayBeDegrees(*two)) {
    return false;
  }
  const auto north = parseDegreesMinutes(one->literal->digits);
  const auto east = parseDegreesMinutes(two->literal->digits);
  const Half& wrong = north && north->minutes >= kMinutes ? *one : *two;
  const auto parts = &wrong == &*one ? north : east;
  if (!north || !east || parts->minutes < kMinutes) {
    return false;
  }
  const ast::Expr& place = &wrong == &*one ? first : second;
  const std::string latitude = one->with(one->negative ? "S" : "N");
  auto report = scope_.report(support::diagnostics::minutesOver60, place.where,
                              scope_.text(place.where), parts->degrees, parts->minutes);
  if (!two->negative) {  // no fix: only the pilot knows on which side a letter or a sign was lost
    const bool turned = one->negative;  // the longitude of a place in the west may come first
    report.hint(turned ? fmt::format("write decimal degrees with letters, the latitude first: "
                                     "`{}, {}`, or `{}, {}` if `{}` is the longitude",
                                     latitude, two->with("E"), two->with("N"), one->with("W"),
                                     one->text())
                       : fmt::format("write decimal degrees with letters: `{0}, {1}` or `{0}, {2}`",
                                     latitude, two->with("E"), two->with("W")));
    return true;
  }
  report.hint(fmt::format("write decimal degrees with letters: `{}, {}`", latitude, two->with("W")))
      .fix(first.where, latitude)
      .fix(second.where, two->with("W"));
  return true;
}

bool ExprLowering::areBareHalves(const ast::Expr& first, const ast::Expr& second, bool degrees) {
  const auto one = halfOf(first);
  const auto two = halfOf(second);
  return one && two && one->bare() && two->bare() &&
         (!degrees || (mayBeDegrees(*one) && mayBeDegrees(*two)));
}

bool ExprLowering::longitudeFirst(const ast::Expr& first, const ast::Expr& second,
                                  std::string_view between) {
  const auto one = halfOf(first);
  const auto two = halfOf(second);
  if (!one || !two || !isSwapped(*one, *two)) {
    return false;
  }
  auto report = scope_.report(
      support::diagnostics::longitudeFirst, first.where, scope_.text(first.where),
      fmt::format("{}{}{}", two->text(), between, one->text()), otherwise(*one, *two, between));
  if (areLettersSwapped(*one, *two)) {
    report.hint(
        fmt::format("the letters are probably swapped: write `{}{}{}`; if the numbers are, "
                    "`{}{}{}`",
                    one->with(two->literal->unit), between, two->with(one->literal->unit),
                    two->text(), between, one->text()));
  }
  return true;
}

}  // namespace glider::frontend
