// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "ir/eval/arithmetic.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

// Values that are places: `here`, `position(latitude, longitude)`, `offset(p, bearing, distance)`.
// Both halves of a place are known or neither is, so that a variable never has one half of each of
// two places.

namespace glider::frontend {

ExprLowering::Result ExprLowering::placeOf(const ast::Invocation& node, const ast::Expr& expr) {
  const std::string& name = node.function.text;
  const bool by_halves = name == "position";
  const size_t wanted = by_halves ? 2 : 3;
  const size_t given = node.arguments.size();
  // `offset(3910.5, -7349.8, …)`: the place is two numbers.
  const bool split = !by_halves && given == wanted + 1;
  if (given != wanted && !split) {
    scope_.report(support::diagnostics::wrongArgumentCount, expr.where, name,
                  by_halves ? "a latitude and a longitude" : "a position, a bearing and a distance",
                  given == 0   ? "none"
                  : given == 1 ? "1 argument"
                               : fmt::format("{} arguments", given),
                  by_halves ? "position(lat, lon)" : "offset(here, 90 deg, 2 km)");
    return std::nullopt;
  }
  const ast::Expr& first = *node.arguments[0].value;
  if (by_halves || split) {
    const ast::Expr& second = *node.arguments[1].value;
    if (longitudeFirst(first, second)) {
      return std::nullopt;
    }
    const auto north = lowerAs(first, latitude(), fmt::format("the latitude of `{}`", name));
    const auto east = lowerAs(second, longitude(), fmt::format("the longitude of `{}`", name));
    if (!north || !east) {
      return std::nullopt;
    }
    const Value place{*north, latitude(), *east};
    return by_halves ? wholePlace(place, expr.where) : offset(place, node, expr);
  }
  const auto from = lowerDeclared(first, {latitude(), true}, "the position of `offset`");
  return from ? offset(*from, node, expr) : std::nullopt;
}

ExprLowering::Result ExprLowering::offset(const Value& from, const ast::Invocation& node,
                                          const ast::Expr& expr) {
  const size_t last = node.arguments.size() - 1;
  const auto bearing = lowerAs(*node.arguments[last - 1].value, quantity(support::dimension::angle),
                               "the bearing of `offset`");
  const auto distance = lowerAs(*node.arguments[last].value, quantity(support::dimension::length),
                                "the distance of `offset`");
  if (!bearing || !distance) {
    return std::nullopt;
  }
  const auto half = [&](ir::Op op, const ir::Type& type) {
    const Value value = emit(op, type, expr.where, {from.id, from.longitude, *bearing, *distance});
    const auto known = evaluate(scope_.mission, value.id);
    return known && ir::isKnown(*known) ? emitNumber(*known, type, expr.where) : value;
  };
  Value place = half(ir::Op::OffsetLatitude, latitude());
  place.longitude = half(ir::Op::OffsetLongitude, longitude()).id;
  return place;
}

Value ExprLowering::wholePlace(const Value& place, const support::SourceRange& range) {
  if (evaluate(scope_.mission, place.id) && evaluate(scope_.mission, place.longitude)) {
    return place;
  }
  const auto knownWith = [&](ir::ExprId half, ir::ExprId other, const ir::Type& type) {
    const ir::ExprId same = emit(ir::Op::Equal, boolean(), range, {other, other}).id;
    return emit(ir::Op::Select, type, range, {same, half, half}).id;
  };
  return {knownWith(place.id, place.longitude, latitude()), latitude(),
          knownWith(place.longitude, place.id, longitude())};
}

}  // namespace glider::frontend
