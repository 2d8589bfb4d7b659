// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/arrays/declared_array.h"

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::frontend {

std::optional<size_t> arraySize(const ast::Expr& size, Scope& scope) {
  Context context = scope.context;
  context.constant = "the size of an array";
  context.list.reset();
  const Scope::Within within(scope, context);
  const size_t before = scope.mission.exprs.size();
  const auto number = ExprLowering(scope).lowerAs(size, plainNumber(), "the size of an array");
  const auto known = number ? evaluate(scope.mission, *number) : std::nullopt;
  scope.mission.exprs.resize(before);
  if (!number) {
    return std::nullopt;
  }
  if (!known) {
    scope.report(support::diagnostics::notConstant, size.where, scope.text(size.where),
                 "the size of an array");
    return std::nullopt;
  }
  if (!(*known >= kFewestElements && *known <= kMostElements && *known == std::floor(*known))) {
    scope.report(support::diagnostics::arraySize, size.where, kMostElements,
                 std::isnan(*known) ? "unknown" : fmt::format("{:.10g}", *known));
    return std::nullopt;
  }
  return static_cast<size_t>(*known);
}

std::optional<std::vector<const ast::Expr*>> startsOf(const ast::Name& name, size_t size,
                                                      const ast::Expr& value, Scope& scope) {
  const auto* list = std::get_if<ast::List>(&value.node);
  if (list == nullptr || size == 0) {
    return std::vector<const ast::Expr*>(std::max(size, size_t{1}), &value);
  }
  if (list->items.size() != size) {
    const size_t given = list->items.size();
    scope.report(
        support::diagnostics::arrayValues, value.where, name.text, size,
        given == 1 ? "this list has 1 value" : fmt::format("this list has {} values", given));
    return std::nullopt;
  }
  std::vector<const ast::Expr*> all;
  for (const ast::Expr& item : list->items) {
    all.push_back(&item);
  }
  return all;
}

}  // namespace glider::frontend
