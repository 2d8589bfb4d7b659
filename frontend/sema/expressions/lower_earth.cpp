// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

namespace glider::frontend {

ExprLowering::Result ExprLowering::onEarth(const ast::Invocation& node, const ast::Expr& expr) {
  const std::string& name = node.function.text;
  if (name == "count") {
    return countOfPath(node, expr);
  }
  if (name == "lanes") {
    refusePath(expr);
    return std::nullopt;
  }
  if (name != "inside") {
    return betweenPlaces(name == "distance" ? ir::Op::Distance : ir::Op::Bearing, node, expr);
  }
  const auto corners = places(node);
  if (!corners) {
    return std::nullopt;
  }
  if (corners->size() < 3) {
    scope_.report(support::diagnostics::tooFewCorners, expr.where, corners->size());
    return std::nullopt;
  }
  return inside(*corners, expr.where);
}

ExprLowering::Result ExprLowering::betweenPlaces(ir::Op op, const ast::Invocation& node,
                                                 const ast::Expr& expr) {
  const auto given = places(node);
  if (!given) {
    return std::nullopt;
  }
  if (given->empty() || given->size() > 2) {
    const std::string& name = node.function.text;
    scope_
        .report(support::diagnostics::wrongArgumentCount, expr.where, name, "1 or 2 positions",
                given->empty() ? "none" : std::to_string(given->size()), name + "(to)")
        .hint(fmt::format("write `{0}(to)` from the current position, or `{0}(from, to)`", name));
    return std::nullopt;
  }
  const Result from = given->size() == 2 ? given->front() : here(expr.where);
  if (!from) {
    return std::nullopt;
  }
  const Value& to = given->back();
  const auto dimension =
      op == ir::Op::Distance ? support::dimension::length : support::dimension::angle;
  return emit(op, quantity(dimension), expr.where,
              {from->id, from->longitude, to.id, to.longitude});
}

ExprLowering::Result ExprLowering::here(const support::SourceRange& range) {
  Value value;
  for (const char* name : {"lat", "lon"}) {
    const platforms::PlatformSensor* found = scope_.platform().find(name);
    if (found == nullptr) {
      scope_.reportUnknown(support::diagnostics::unknownSensor, range, scope_.suggestSensor(name),
                           scope_.platform().name, name);
      return std::nullopt;
    }
    const Result half = sensor(*found, name, range);
    (value.id.valid() ? value.longitude : value.id) = half->id;
  }
  value.type = latitude();
  return value;
}

std::optional<std::vector<Value>> ExprLowering::places(const ast::Invocation& node) {
  std::vector<Value> found;
  bool good = true;
  for (size_t i = 0; i < node.arguments.size(); ++i) {
    const ast::Expr& argument = *node.arguments[i].value;
    if (isPath(argument, scope_)) {
      const auto path = lowerPath(argument);
      good = good && path;
      for (const Place& place : path.value_or(Path())) {
        found.push_back(emitPlace(place, argument.where));
      }
      continue;
    }
    if (i + 1 < node.arguments.size() && longitudeFirst(argument, *node.arguments[i + 1].value)) {
      good = false;
      found.emplace_back();
      ++i;
      continue;
    }
    const Result first = lower(argument, latitude());
    if (!first || first->longitude.valid()) {
      good = good && first;
      found.push_back(first.value_or(Value()));
      continue;
    }
    if (first->type != latitude() || i + 1 == node.arguments.size()) {
      scope_.report(support::diagnostics::notAPosition, argument.where, scope_.text(argument.where),
                    describe(first->type), node.function.text);
      return std::nullopt;
    }
    ++i;
    const auto second = lowerAs(*node.arguments[i].value, longitude(),
                                "the longitude that follows `" + scope_.text(argument.where) + "`");
    good = good && second;
    found.push_back({first->id, latitude(), second.value_or(ir::ExprId())});
  }
  return good ? std::optional(std::move(found)) : std::nullopt;
}

}  // namespace glider::frontend
