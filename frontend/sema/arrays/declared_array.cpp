// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/arrays/declared_array.h"

#include "frontend/sema/arrays/constant_number.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::frontend {

std::optional<size_t> arraySize(const ast::Expr& size, Scope& scope) {
  const auto known = constantNumber(size, "the size of an array", scope);
  if (!known) {
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
