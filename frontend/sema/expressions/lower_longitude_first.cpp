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

}  // namespace

bool ExprLowering::longitudeFirst(const ast::Expr& first, const ast::Expr& second,
                                  std::string_view between) {
  const auto one = halfOf(first);
  const auto two = halfOf(second);
  if (!one || !two || !isSwapped(*one, *two)) {
    return false;
  }
  scope_.report(support::diagnostics::longitudeFirst, first.where, scope_.text(first.where),
                fmt::format("{}{}{}", two->text(), between, one->text()),
                otherwise(*one, *two, between));
  return true;
}

}  // namespace glider::frontend
