// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::frontend {

namespace {

constexpr std::string_view kLanes = "lanes";

/// The path that a name refers to.
const Path* findPath(std::string_view name, Scope& scope) {
  if (Named* named = scope.findNamed(name)) {
    named->read = named->read || named->type.path;
    return named->type.path && named->valid ? &named->path.path : nullptr;
  }
  const Constant* found = scope.findConstant(name);
  return found != nullptr && !found->path.empty() ? &found->path : nullptr;
}

const Path* findPath(const ast::Expr& expr, Scope& scope) {
  const auto* use = std::get_if<ast::NameUse>(&expr.node);
  return use == nullptr ? nullptr : findPath(use->name, scope);
}

/// Whether an expression names a constant with an error that has already been reported.
bool wasRefused(const ast::Expr& expr, Scope& scope) {
  const auto* use = std::get_if<ast::NameUse>(&expr.node);
  const Constant* found = use == nullptr ? nullptr : scope.findConstant(use->name);
  return found != nullptr && found->worked_out && !found->valid;
}

/// Whether it is half a position, `39.2 N`, or was a position that the parser has refused: a number
/// with a space or a comma in it.
bool isOfPosition(const ast::Expr& expr) {
  const auto* literal = std::get_if<ast::Literal>(&expr.node);
  return literal != nullptr &&
         (literal->unit == "N" || literal->unit == "S" || literal->unit == "E" ||
          literal->unit == "W" || literal->digits.find_first_of(" ,") != std::string::npos);
}

}  // namespace

bool isPath(const ast::Expr& expr, Scope& scope) {
  if (const auto* list = std::get_if<ast::List>(&expr.node)) {
    return list->items.empty() || std::ranges::any_of(list->items, [&](const ast::Expr& item) {
             return isPosition(item, scope) || isOfPosition(item);
           });
  }
  const auto* call = std::get_if<ast::Invocation>(&expr.node);
  return findPath(expr, scope) != nullptr || (call != nullptr && call->function.text == kLanes);
}

std::optional<Path> ExprLowering::lowerPath(const ast::Expr& expr) {
  if (const Path* path = findPath(expr, scope_)) {
    return *path;
  }
  if (const auto* call = std::get_if<ast::Invocation>(&expr.node);
      call != nullptr && call->function.text == kLanes) {
    return lanes(*call, expr);
  }
  const auto* list = std::get_if<ast::List>(&expr.node);
  if (list == nullptr && wasRefused(expr, scope_)) {
    return std::nullopt;
  }
  if (list == nullptr) {
    scope_.report(support::diagnostics::notAPath, expr.where, scope_.text(expr.where));
    return std::nullopt;
  }
  if (list->items.empty()) {
    scope_.report(support::diagnostics::emptyPath, expr.where);
    return std::nullopt;
  }
  Path path;
  bool good = true;
  for (const ast::Expr& item : list->items) {
    const auto place = constantPlace(item);
    good = good && place;
    path.push_back(place.value_or(Place()));
  }
  return good ? std::optional(std::move(path)) : std::nullopt;
}

std::optional<Place> ExprLowering::constantPlace(const ast::Expr& expr) {
  const size_t before = scope_.mission.exprs.size();
  Context context = scope_.context;
  context.constant = "a path";
  const Scope::Within within(scope_, context);
  const auto value = lowerDeclared(expr, {latitude(), true}, "an element of a path");
  std::optional<Place> place;
  if (value) {
    const auto north = evaluate(scope_.mission, value->id);
    const auto east = evaluate(scope_.mission, value->longitude);
    if (north && east) {
      place = {*north, *east};
    } else {
      scope_.report(support::diagnostics::notConstant, expr.where, scope_.text(expr.where),
                    "a path");
    }
  }
  scope_.mission.exprs.resize(before);
  return place;
}

Value ExprLowering::emitPlace(const Place& place, const support::SourceRange& range) {
  Value value = emitNumber(place.latitude, latitude(), range);
  value.longitude = emitNumber(place.longitude, longitude(), range).id;
  return value;
}

void ExprLowering::refusePath(const ast::Expr& expr) {
  if (const auto* list = std::get_if<ast::List>(&expr.node);
      list != nullptr && !isPath(expr, scope_)) {
    const std::string what = fmt::format("a list of {} values", list->items.size());
    scope_.report(
        support::diagnostics::arrayAsValue, expr.where, scope_.text(expr.where), what,
        "a list gives the values of an array: `var depths[3]: length = [10 m, 20 m, 30 m]`");
    return;
  }
  scope_.report(support::diagnostics::pathAsValue, expr.where, scope_.text(expr.where));
}

ExprLowering::Result ExprLowering::visit(const ast::List&, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  refusePath(expr);
  return std::nullopt;
}

ExprLowering::Result ExprLowering::countOfPath(const ast::Invocation& node, const ast::Expr& expr) {
  if (const auto array = onlyArray(node)) {
    if (array->named != nullptr) {
      array->named->read = true;
    }
    return emitNumber(static_cast<double>(array->size), plainNumber(), expr.where);
  }
  if (node.arguments.size() != 1) {
    scope_.report(support::diagnostics::wrongArgumentCount, expr.where, "count", "1 argument",
                  node.arguments.empty() ? "none" : fmt::format("{}", node.arguments.size()),
                  "count(track)");
    return std::nullopt;
  }
  const auto path = lowerPath(*node.arguments.front().value);
  return path ? Result(emitNumber(static_cast<double>(path->size()), plainNumber(), expr.where))
              : std::nullopt;
}

ExprLowering::Result ExprLowering::visit(const ast::Index& node, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  if (const auto array = findArray(node.list.text, scope_)) {
    return element(*array, node, expr);
  }
  const ast::Expr list{ast::NameUse{node.list.text}, node.list.where};
  if (findPath(list, scope_) == nullptr && !wasRefused(list, scope_)) {
    refuseIndexed(node.list);
    return std::nullopt;
  }
  const auto path = lowerPath(list);
  const auto number =
      lowerAs(*node.position, plainNumber(), "the number in `" + node.list.text + "[…]`");
  if (!path || !number) {
    return std::nullopt;
  }
  const auto known = evaluate(scope_.mission, *number);
  if (!known) {
    return chosen(*path, {*number, plainNumber(), {}}, expr.where);
  }
  const bool there =
      *known >= 0 && *known < static_cast<double>(path->size()) && *known == std::floor(*known);
  if (!there && scope_.context.checkedAlone()) {
    return chosen(*path, {*number, plainNumber(), {}}, expr.where);
  }
  if (!there) {
    scope_.report(support::diagnostics::outsidePath, node.position->where, node.list.text,
                  path->size() == 1 ? "1 position" : fmt::format("{} positions", path->size()),
                  *known);
    return std::nullopt;
  }
  return emitPlace((*path)[static_cast<size_t>(*known)], expr.where);
}

/// The place with number `index`; unknown if there is none.
ExprLowering::Result ExprLowering::chosen(const Path& path, const Value& index,
                                          const support::SourceRange& range) {
  ir::Table north{latitude(), {}};
  ir::Table east{longitude(), {}};
  for (const Place& place : path) {
    north.values.push_back(place.latitude);
    east.values.push_back(place.longitude);
  }
  const auto element = [&](ir::Table table) {
    const ir::TableId number = scope_.table(std::move(table));
    return valueOf(ir::MissionWriter(scope_.mission, range).element(number, index.id));
  };
  Value result = element(std::move(north));
  result.longitude = element(std::move(east)).id;
  return result;
}

}  // namespace glider::frontend
