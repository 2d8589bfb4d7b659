// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/usual_argument.h"

#include "support/diagnostics/ids/meaning.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {
namespace {

/// Whether it is a number with a unit of that dimension.
bool isLiteralOf(const ast::Argument& argument, const support::Dimension& dimension) {
  const auto* literal = std::get_if<ast::Literal>(&argument.value->node);
  const auto unit = literal != nullptr ? support::parseUnit(literal->unit) : std::nullopt;
  return unit && unit->dimension == dimension;
}

}  // namespace

std::optional<Value> lowerUsual(const Signature::Formal& formal, const std::string& what,
                                const support::SourceRange& where, Scope& scope) {
  if (!formal.usual->where.valid()) {
    return ExprLowering(scope).usualSlope(scope.platform().envelope.steersBySpeed(), where);
  }
  Context context;
  context.isolated = true;
  context.constant = "a usual argument";
  const Scope::Within within(scope, context);
  return ExprLowering(scope).lowerDeclared(*formal.usual, formal.type, what);
}

bool refuseOtherSlope(const std::vector<ast::Argument>& arguments, const Callee& callee,
                      Scope& scope) {
  const bool speed = scope.platform().envelope.steersBySpeed();
  const auto& told = speed ? support::dimension::speed : support::dimension::angle;
  const bool takes = std::ranges::any_of(callee.signature.formals, [&](const auto& formal) {
    return formal.usual != nullptr && formal.type.type == quantity(told);
  });
  const auto& other = speed ? support::dimension::angle : support::dimension::speed;
  const auto wrong = std::ranges::find_if(
      arguments, [&](const ast::Argument& argument) { return isLiteralOf(argument, other); });
  if (!takes || wrong == arguments.end()) {
    return false;
  }
  scope.report(support::diagnostics::otherSlope, wrong->value->where, scope.platform().name,
               speed ? "goes to a depth at a speed, not at a pitch"
                     : "goes to a depth at a pitch, not at a speed",
               scope.text(wrong->value->where),
               fmt::format("leave it out, or write `{}`", callee.signature.text));
  return true;
}

}  // namespace glider::frontend
