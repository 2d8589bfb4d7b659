// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <array>

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
    const ast::Expr* next = i + 1 < node.arguments.size() ? &*node.arguments[i + 1].value : nullptr;
    if (next != nullptr && (longitudeFirst(argument, *next) || decimalDegrees(argument, *next))) {
      good = false;
      found.emplace_back();
      ++i;
      continue;
    }
    const Result first = lower(argument, latitude());
    if (!first && next != nullptr && areBareHalves(argument, *next, false)) {
      if (!areBareHalves(argument, *next, true)) {
        lowerAs(*next, longitude(), "the longitude that follows");
      }
      ++i;
    }
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

// How far the vehicles of the line `vehicles` are: `peers within 2 km` and `nearest`. Nothing is
// ever received from this vehicle itself, so it is none of those whose position is known.

/// Whether what the words need is declared; else it is reported, once.
bool ExprLowering::hasPositions(std::string_view words, const support::SourceRange& range) {
  if (scope_.context.at_start || !scope_.context.constant.empty()) {
    scope_.report(support::diagnostics::needsPositions, range, words,
                  "what is received while the mission runs",
                  "set a variable in a `do`: nothing is received before");
    return false;
  }
  if (scope_.vehicles.empty()) {
    scope_.report(support::diagnostics::needsPositions, range, words, "a line `vehicles`",
                  "write for example `vehicles ada, bob` at the top of the mission");
    return false;
  }
  for (const auto& [half, kind] : {std::pair("lat", platforms::SensorKind::Latitude),
                                   std::pair("lon", platforms::SensorKind::Longitude)}) {
    const std::string name = std::string(kPeerPrefix) + half;
    if (scope_.refused_names.contains(name)) {
      return false;
    }
    const platforms::PlatformSensor* received = scope_.findSensor(name);
    if (received == nullptr || received->kind != kind) {
      scope_.report(support::diagnostics::needsPositions, range, words,
                    "the shares of `lat` and of `lon`",
                    "write for example `share lat in 39 N .. 40 N precision 0.0001 deg every "
                    "5 min`");
      return false;
    }
  }
  return true;
}

std::optional<std::vector<ir::ExprId>> ExprLowering::neighbours(std::string_view words,
                                                                const support::SourceRange& range) {
  const Result own = hasPositions(words, range) ? here(range) : std::nullopt;
  if (!own) {
    return std::nullopt;
  }
  std::vector<ir::ExprId> distances;
  for (const std::string& vehicle : scope_.vehicles) {
    std::array<ir::ExprId, 2> place;
    for (size_t i = 0; i < place.size(); ++i) {
      const std::string name = vehicle + (i == 0 ? ".lat" : ".lon");
      const platforms::PlatformSensor* received = scope_.findSensor(name);
      if (received == nullptr) {
        return std::nullopt;  // its name was refused
      }
      place.at(i) = sensor(*received, name, range)->id;
      reads_.back().implied = true;
    }
    distances.push_back(emit(ir::Op::Distance, quantity(support::dimension::length), range,
                             {own->id, own->longitude, place[0], place[1]})
                            .id);
  }
  return distances;
}

/// How many distances are known and not above the radius.
ExprLowering::Result ExprLowering::peersWithin(const ast::Invocation& node, const ast::Expr& expr) {
  const auto radius = lowerAs(*node.arguments.front().value, quantity(support::dimension::length),
                              "the distance of `peers within`");
  const auto distances = radius ? neighbours(ast::kPeersWithin, node.function.where) : std::nullopt;
  if (!distances) {
    return std::nullopt;
  }
  const auto number = [&](double value) { return emitNumber(value, plainNumber(), expr.where).id; };
  ir::ExprId sum;
  for (const ir::ExprId distance : *distances) {
    const ir::ExprId known = emit(ir::Op::Known, boolean(), expr.where, {distance}).id;
    const ir::ExprId near = emit(ir::Op::LessEqual, boolean(), expr.where, {distance, *radius}).id;
    const ir::ExprId both = emit(ir::Op::And, boolean(), expr.where, {known, near}).id;
    const ir::ExprId one =
        emit(ir::Op::Select, plainNumber(), expr.where, {both, number(1), number(0)}).id;
    sum = sum.valid() ? emit(ir::Op::Add, plainNumber(), expr.where, {sum, one}).id : one;
  }
  return valueOf(sum);
}

/// The least distance that is known; unknown if none is.
ExprLowering::Result ExprLowering::nearest(const support::SourceRange& range) {
  const auto distances = neighbours("nearest", range);
  if (!distances) {
    return std::nullopt;
  }
  const ir::Type length = quantity(support::dimension::length);
  const auto select = [&](ir::ExprId value, ir::ExprId then, ir::ExprId otherwise) {
    const ir::ExprId known = emit(ir::Op::Known, boolean(), range, {value}).id;
    return emit(ir::Op::Select, length, range, {known, then, otherwise}).id;
  };
  ir::ExprId least = distances->front();
  for (size_t i = 1; i < distances->size(); ++i) {
    const ir::ExprId other = distances->at(i);
    const ir::ExprId both = emit(ir::Op::Min, length, range, {least, other}).id;
    least = select(least, select(other, both, least), other);
  }
  return valueOf(least);
}

}  // namespace glider::frontend
