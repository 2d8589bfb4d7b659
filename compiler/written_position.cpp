// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/written_position.h"

#include "frontend/sema/expressions/literals.h"
#include "support/units/position_text.h"

#include <string_view>
#include <variant>

namespace glider::compiler {
namespace {

/// Degrees, north and east positive; empty for a number with a unit.
std::optional<double> degreesOf(const ast::Literal& half) {
  const bool letter =
      half.unit.size() == 1 && std::string_view("NESW").find(half.unit) != std::string_view::npos;
  if (!letter && !half.unit.empty()) {
    return std::nullopt;
  }
  const auto parts =
      letter ? frontend::parseLettered(half.digits) : frontend::parseDegreesMinutes(half.digits);
  if (!parts) {
    return std::nullopt;
  }
  const bool negative = half.unit == "S" || half.unit == "W";
  return negative ? -parts->value() : parts->value();
}

std::optional<double> degreesOf(const ast::Expr& half) {
  if (const auto* unary = std::get_if<ast::Unary>(&half.node);
      unary != nullptr && unary->op == ast::UnaryOp::Negate) {
    const auto degrees = degreesOf(*unary->operand);
    return degrees ? std::optional(-*degrees) : std::nullopt;
  }
  const auto* number = std::get_if<ast::Literal>(&half.node);
  return number != nullptr ? degreesOf(*number) : std::nullopt;
}

std::optional<std::string> textOf(std::optional<double> latitude, std::optional<double> longitude) {
  return latitude && longitude ? std::optional(support::positionText(*latitude, *longitude))
                               : std::nullopt;
}

}  // namespace

std::optional<std::string> positionText(const ast::Expr& written) {
  const auto* position = std::get_if<ast::Position>(&written.node);
  return position != nullptr ? textOf(degreesOf(position->latitude), degreesOf(position->longitude))
                             : std::nullopt;
}

std::optional<std::string> positionText(const ast::Expr& latitude, const ast::Expr& longitude) {
  return textOf(degreesOf(latitude), degreesOf(longitude));
}

}  // namespace glider::compiler
