// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/states/moving_place.h"

#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <algorithm>

namespace glider::frontend {
namespace {

/// Whether a place is `here`, or a place relative to it.
bool moves(const ast::Expr& expr, Scope& scope) {
  if (const auto* use = std::get_if<ast::NameUse>(&expr.node)) {
    return use->name == "here" && meansValue(use->name, expr.where, scope);
  }
  const auto* call = std::get_if<ast::Invocation>(&expr.node);
  return call != nullptr && call->function.text == "offset" && isPosition(expr, scope) &&
         !call->arguments.empty() && moves(*call->arguments.front().value, scope);
}

}  // namespace

void warnOfMovingPlaces(const ast::Use& route, Scope& scope) {
  for (const ast::Argument& argument : route.arguments) {
    if (moves(*argument.value, scope)) {
      scope.report(support::diagnostics::movingPlace, argument.value->where,
                   scope.text(argument.value->where));
    }
  }
}

}  // namespace glider::frontend
