// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/arrays/constant_number.h"

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

namespace glider::frontend {

std::optional<double> constantNumber(const ast::Expr& expr, const std::string& what, Scope& scope) {
  Context context = scope.context;
  context.constant = what;
  context.list.reset();
  const Scope::Within within(scope, context);
  const size_t before = scope.mission.exprs.size();
  const auto number = ExprLowering(scope).lowerAs(expr, plainNumber(), what);
  const auto known = number ? evaluate(scope.mission, *number) : std::nullopt;
  scope.mission.exprs.resize(before);
  if (number && !known) {
    scope.report(support::diagnostics::notConstant, expr.where, scope.text(expr.where), what);
  }
  return known;
}

}  // namespace glider::frontend
