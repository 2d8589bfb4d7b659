// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/evaluate.h"
#include "frontend/sema/lower_expr.h"
#include "ir/core/ops.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

using support::DiagnosticId;

namespace {

struct WindowFunction {
  std::string_view name;
  ir::TemporalKind kind;
};

constexpr WindowFunction kWindows[] = {
    {"mean", ir::TemporalKind::Mean},       {"lowest", ir::TemporalKind::Lowest},
    {"highest", ir::TemporalKind::Highest}, {"spread", ir::TemporalKind::Spread},
    {"rate", ir::TemporalKind::Slope},      {"slope", ir::TemporalKind::Slope}};

}  // namespace

namespace {

bool isConstant(const Snippet& snippet) {
  return std::ranges::none_of(snippet, [](const ir::Expr& expr) {
    using enum ir::Op;
    return expr.op != Constant && expr.op != True && expr.op != False &&
           ir::opInfo(expr.op).operands == 0;
  });
}

/// The names in an expression, in the order written.
void collectNames(const ast::Expr& expr, std::vector<std::string_view>& names) {
  if (const auto* use = std::get_if<ast::NameUse>(&expr.node)) {
    names.push_back(use->name);
  } else if (const auto* unary = std::get_if<ast::Unary>(&expr.node)) {
    collectNames(*unary->operand, names);
  } else if (const auto* binary = std::get_if<ast::Binary>(&expr.node)) {
    collectNames(*binary->left, names);
    collectNames(*binary->right, names);
  } else if (const auto* call = std::get_if<ast::Invocation>(&expr.node)) {
    for (const ast::Argument& argument : call->arguments) {
      collectNames(*argument.value, names);
    }
  }
}

/// In a behaviour that is lowered for a use, the parameter by which `expr` is what it is: the first
/// that is not constant, else the first; null if it names none.
const Named* blamed(const ast::Expr& expr, Scope& scope) {
  std::vector<std::string_view> names;
  collectNames(expr, names);
  const Named* first = nullptr;
  for (const std::string_view name : names) {
    const Named* named = scope.findNamed(name);
    if (named == nullptr || named->arguments.empty()) {
      continue;
    }
    if (!isConstant(named->arguments.front())) {
      return named;
    }
    first = first == nullptr ? named : first;
  }
  return first;
}

}  // namespace

bool isWindowName(std::string_view name) {
  return std::ranges::find(kWindows, name, &WindowFunction::name) != std::end(kWindows);
}

/// `mean(x, 60 s)`, `slope(x, 10 m of depth)`.
ExprLowering::Result ExprLowering::window(const ast::Invocation& node, const ast::Expr& expr) {
  const std::string& name = node.function.text;
  if (!scope_.context.list) {
    scope_.report(DiagnosticId::overTimeNowhere, expr.where, name);
    return std::nullopt;
  }
  const std::string form = name + (name == "slope" ? "(x, 10 m of depth)" : "(x, 60 s)");
  if (node.arguments.size() != 2) {
    const size_t count = node.arguments.size();
    scope_.report(DiagnosticId::wrongArgumentCount, expr.where, name, "2 arguments",
                  count == 0   ? "none"
                  : count == 1 ? "1 argument"
                               : std::to_string(count) + " arguments",
                  "write `" + form + "`");
    return std::nullopt;
  }
  if (const ast::Argument& first = node.arguments.front(); first.of) {
    scope_.report(DiagnosticId::ofOutsideWindow, first.of->where, scope_.text(first.value->where));
    return std::nullopt;
  }
  const ast::Argument& over = node.arguments.back();
  if (name == (over.of ? "rate" : "slope")) {
    scope_.report(DiagnosticId::rateOrSlope, expr.where, name, over.of ? "a time" : "a stretch",
                  over.of ? "a stretch" : "no stretch", over.of ? "slope" : "rate");
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
    const platforms::PlatformSensor* along = scope_.findNamed(over.of->text) == nullptr
                                                 ? scope_.platform().find(over.of->text)
                                                 : nullptr;
    if (along == nullptr || along->kind != platforms::SensorKind::Quantity) {
      scope_.report(DiagnosticId::stretchOfWhat, over.of->where, over.of->text);
      return std::nullopt;
    }
    const Result value = sensor(*along, over.of->text, over.of->where);
    if (!value) {
      return std::nullopt;
    }
    result.along = value->id;
    result.dimension = value->type.dimension;
  }
  const std::string what = "the length of `" + std::string(function) + "`";
  const auto length = lowerAs(*over.value, quantity(result.dimension), what);
  if (!length) {
    return std::nullopt;
  }
  const auto known = evaluate(scope_.mission, *length);
  // A behaviour's parameters are known where it is used, not where it is checked by itself.
  const bool checked_alone = scope_.context.isolated && !scope_.context.state.valid();
  if (!known && !checked_alone) {
    refuseLength(DiagnosticId::notConstant, *over.value, function);
    return std::nullopt;
  }
  result.length = known.value_or(1.0);
  if (!(result.length > 0)) {
    refuseLength(DiagnosticId::windowLength, *over.value, function);
    return std::nullopt;
  }
  return result;
}

void ExprLowering::refuseLength(DiagnosticId id, const ast::Expr& length,
                                std::string_view function) {
  const Named* named = blamed(length, scope_);
  if (named == nullptr) {
    scope_.report(id, length.where, scope_.text(length.where),
                  fmt::format("the length of `{}`", function));
    return;
  }
  // Once, however many windows are that long: the places and the words are the same.
  const support::SourceRange given = named->arguments.front().back().range;
  scope_.diagnostics()
      .report(id, given, scope_.text(given),
              fmt::format("`{}` of `{}`", named->name->text, scope_.context.behaviour))
      .note(length.where, "it is the length of a window here");
}

ExprLowering::Result ExprLowering::emitWindow(std::string_view name, const Value& operand,
                                              const WindowLength& length,
                                              const support::SourceRange& range) {
  ir::Temporal temporal;
  temporal.kind = std::ranges::find(kWindows, name, &WindowFunction::name)->kind;
  temporal.list = *scope_.context.list;
  temporal.state = scope_.context.state;
  temporal.operand = operand.id;
  temporal.length = length.length;
  temporal.along = length.along;
  temporal.range = range;
  ir::Type type = operand.type;
  if (temporal.kind == ir::TemporalKind::Slope) {
    const auto dimension = support::quotient(type.dimension, length.dimension);
    if (!dimension) {
      return std::nullopt;
    }
    type = quantity(*dimension);
  }
  scope_.mission.temporals.push_back(temporal);
  const Value value = emit(ir::Op::Temporal, type, range, {});
  scope_.mission.exprs[value.id.index].temporal = {
      static_cast<uint32_t>(scope_.mission.temporals.size() - 1)};
  return value;
}

}  // namespace glider::frontend
