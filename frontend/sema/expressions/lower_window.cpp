// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/functions.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

namespace glider::frontend {

/// `mean(x, 60 s)`, `slope(x, 10 m of depth)`.
ExprLowering::Result ExprLowering::window(const ast::Invocation& node, const ast::Expr& expr) {
  const std::string& name = node.function.text;
  if (!scope_.context.list) {
    scope_.report(support::diagnostics::overTimeNowhere, expr.where, name);
    return std::nullopt;
  }
  const std::string form = name + (name == "slope" ? "(x, 10 m of depth)" : "(x, 60 s)");
  if (node.arguments.size() != 2) {
    const size_t count = node.arguments.size();
    scope_.report(support::diagnostics::wrongArgumentCount, expr.where, name, "2 arguments",
                  count == 0   ? "none"
                  : count == 1 ? "1 argument"
                               : std::to_string(count) + " arguments",
                  form);
    return std::nullopt;
  }
  if (const ast::Argument& first = node.arguments.front(); first.of) {
    scope_.report(support::diagnostics::ofOutsideWindow, first.of->where,
                  scope_.text(first.value->where));
    return std::nullopt;
  }
  const ast::Argument& over = node.arguments.back();
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
  return emitWindow(name, *operand, *shape, expr.where);
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
    return std::nullopt;
  }
  return watch(temporal);
}

}  // namespace glider::frontend
