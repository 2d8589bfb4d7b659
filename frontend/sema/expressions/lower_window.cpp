// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/decimal_commas.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/functions.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <utility>

namespace glider::frontend {

/// `mean(x, 60 s)`, `slope(x, 10 m of depth)`.
ExprLowering::Result ExprLowering::window(const ast::Invocation& node, const ast::Expr& expr) {
  const std::string& name = node.function.text;
  if (!scope_.context.list) {
    scope_.refuseOverTime(expr.where, name);
    return std::nullopt;
  }
  const std::string form = name + (name == "slope"            ? "(x, 10 m of depth)"
                                   : isReservedFunction(name) ? "(x, 60 s)"
                                                              : "(x, last leg)");
  const auto fits = [](const std::vector<ast::Argument>& read) { return read.size() == 2; };
  if (!fits(node.arguments) && refuseDecimalCommas(node.arguments, scope_, fits)) {
    return std::nullopt;
  }
  if (!fits(node.arguments)) {
    const size_t count = node.arguments.size();
    scope_.report(support::diagnostics::wrongArgumentCount, expr.where, name, "2 arguments",
                  count == 0   ? "none"
                  : count == 1 ? "1 argument"
                               : std::to_string(count) + " arguments",
                  form);
    return std::nullopt;
  }
  if (lengthFirst(node)) {
    return std::nullopt;
  }
  if (const ast::Argument& first = node.arguments.front(); first.of) {
    scope_.report(support::diagnostics::ofOutsideWindow, first.of->where,
                  scope_.text(first.value->where));
    return std::nullopt;
  }
  const ast::Argument& over = node.arguments.back();
  if (const auto leg = legOf(*over.value); leg && !over.of) {
    return legWindow(node, *leg, expr);
  }
  if (!isReservedFunction(name)) {
    scope_.report(support::diagnostics::legExpected, over.value->where, name,
                  scope_.text(over.value->where), scope_.text(node.arguments.front().value->where));
    return std::nullopt;
  }
  if (name == (over.of ? "rate" : "slope")) {
    scope_.report(support::diagnostics::rateOrSlope, expr.where, name,
                  over.of ? "a time" : "a distance", over.of ? "a distance" : "no distance",
                  over.of ? "slope" : "rate");
    return std::nullopt;
  }
  const ast::Expr& watched = *node.arguments.front().value;
  const Result operand = lower(watched, std::nullopt);
  const auto shape = windowLength(over, name);
  if (!operand || !shape || !numeric(*operand, watched, name, false)) {
    return std::nullopt;
  }
  Result result = emitWindow(name, *operand, *shape, expr.where);
  if (result && name != "rate" && name != "slope") {
    result->scale = operand->scale;
  }
  return result;
}

/// `spread(temp, 10 m)`: true, and reported, if a distance lacks what it is along.
bool ExprLowering::refuseStretch(const ast::Argument& over, std::string_view function) {
  const auto* literal = std::get_if<ast::Literal>(&over.value->node);
  const auto unit = literal != nullptr ? support::parseUnit(literal->unit) : std::nullopt;
  if (over.of || !unit || unit->dimension != support::dimension::length) {
    return false;
  }
  const std::string written = scope_.text(over.value->where);
  scope_.report(support::diagnostics::wrongType, over.value->where,
                fmt::format("the length of `{}`", function), "a time (s)", written, "a length (m)",
                fmt::format("write `{} of depth`, or a time", written));
  return true;
}

std::optional<ExprLowering::WindowLength> ExprLowering::windowLength(const ast::Argument& over,
                                                                     std::string_view function) {
  WindowLength result{0, {}, support::dimension::time};
  if (over.of) {
    const platforms::PlatformSensor* along = scope_.findSensor(over.of->text);
    if (along == nullptr || along->kind != platforms::SensorKind::Quantity) {
      if (!scope_.refused_names.contains(over.of->text)) {
        scope_.report(support::diagnostics::stretchOfWhat, over.of->where, over.of->text);
      }
      return std::nullopt;
    }
    const Result value = sensor(*along, over.of->text, over.of->where);
    if (!value) {
      return std::nullopt;
    }
    result.along = value->id;
    result.dimension = value->type.dimension;
  }
  if (refuseStretch(over, function)) {
    return std::nullopt;
  }
  const auto length =
      positiveConstant(*over.value, quantity(result.dimension),
                       {fmt::format("the length of `{}`", function),
                        "it is the length of a window here", support::diagnostics::windowLength});
  if (!length) {
    return std::nullopt;
  }
  result.length = *length;
  return result;
}

ExprLowering::Result ExprLowering::emitWindow(std::string_view name, const Value& operand,
                                              const WindowLength& length,
                                              const support::SourceRange& range) {
  ir::Temporal temporal;
  temporal.kind = *findWindow(name);
  temporal.list = *scope_.context.list;
  temporal.state = scope_.context.state;
  temporal.operand = operand.id;
  temporal.length = length.length;
  temporal.along = length.along;
  temporal.range = range;
  if (temporal.kind == ir::TemporalKind::Slope &&
      !support::quotient(operand.type.dimension, length.dimension)) {
    scope_.report(support::diagnostics::noSuchQuantity, range, scope_.text(range));
    return std::nullopt;
  }
  return watch(temporal);
}

// Windows over a dive or climb, `highest(temp, last leg)`, and the number of the yo. What a leg is
// the vehicle says, by the sensor that has the states `diving` and `climbing`.

/// `this leg`, `last dive` and so on, which the parser has read as one name.
std::optional<ExprLowering::LegWords> ExprLowering::legOf(const ast::Expr& length) {
  const auto* use = std::get_if<ast::NameUse>(&length.node);
  const size_t gap = use != nullptr ? use->name.find(' ') : std::string::npos;
  if (gap == std::string::npos) {
    return std::nullopt;
  }
  return LegWords{use->name.starts_with("this") ? ir::Leg::This : ir::Leg::Last,
                  !use->name.ends_with("climb"), !use->name.ends_with("dive")};
}

ExprLowering::Result ExprLowering::legWindow(const ast::Invocation& node, const LegWords& leg,
                                             const ast::Expr& expr) {
  const std::string& name = node.function.text;
  if (name == "rate" || name == "slope") {
    scope_.report(support::diagnostics::notOverALeg, expr.where, name,
                  scope_.text(node.arguments.front().value->where),
                  scope_.text(node.arguments.back().value->where));
    return std::nullopt;
  }
  const ast::Expr& watched = *node.arguments.front().value;
  const Result value = lower(watched, std::nullopt);
  if (!value || !numeric(*value, watched, name, false)) {
    return std::nullopt;
  }
  ir::Temporal temporal;
  temporal.kind = *findWindow(name);
  temporal.operand = value->id;
  if (isReservedFunction(name)) {
    Result result = emitLeg(temporal, leg, name, expr.where);
    if (result) {
      result->scale = value->scale;
    }
    return result;
  }
  const Result depth = depthOf(node, expr);
  if (!depth) {
    return std::nullopt;
  }
  temporal.duration = value->id;
  temporal.operand = depth->id;
  if (temporal.kind == ir::TemporalKind::Steepest) {
    if (!support::quotient(value->type.dimension, depth->type.dimension)) {
      scope_.report(support::diagnostics::noSuchQuantity, expr.where, scope_.text(expr.where));
      return std::nullopt;
    }
    std::swap(temporal.operand, temporal.duration);
  }
  return emitLeg(temporal, leg, name, expr.where);
}

ExprLowering::Result ExprLowering::depthOf(const ast::Invocation& node, const ast::Expr& expr) {
  const platforms::PlatformSensor* depth = scope_.platform().find("depth");
  if (depth == nullptr) {
    scope_.report(support::diagnostics::unknownSensor, expr.where, scope_.platform().name,
                  node.function.text, "the vehicle does not report its depth");
    return std::nullopt;
  }
  return sensor(*depth, "depth", expr.where);
}

ExprLowering::Result ExprLowering::emitLeg(ir::Temporal temporal, const LegWords& leg,
                                           const std::string& written,
                                           const support::SourceRange& range) {
  const auto dive = findSensorState(scope_.platform(), "diving");
  const auto climb = findSensorState(scope_.platform(), "climbing");
  if (!dive || !climb || dive->sensor != climb->sensor) {
    scope_.report(support::diagnostics::unknownSensor, range, scope_.platform().name, written,
                  "the vehicle does not report whether it dives or climbs");
    return std::nullopt;
  }
  temporal.list = *scope_.context.list;
  temporal.state = scope_.context.state;
  temporal.along = sensor(*dive->sensor, dive->sensor->name, range)->id;
  reads_.back().implied = true;  // as by `diving`
  temporal.leg = leg.leg;
  temporal.dive = leg.dives ? dive->value : climb->value;
  temporal.climb = leg.climbs ? climb->value : dive->value;
  temporal.range = range;
  if (!temporal.operand.valid()) {
    temporal.operand = temporal.along;
  }
  return watch(temporal);
}

/// How many dives have begun since the state was entered.
ExprLowering::Result ExprLowering::yoNumber(const support::SourceRange& range) {
  if (!scope_.context.list) {
    scope_.refuseOverTime(range, "yo_number");
    return std::nullopt;
  }
  ir::Temporal temporal;
  temporal.kind = ir::TemporalKind::Number;
  return emitLeg(temporal, {ir::Leg::This, true, false}, "yo_number", range);
}

}  // namespace glider::frontend
