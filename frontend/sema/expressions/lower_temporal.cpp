// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/decimal_commas.h"
#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <variant>

namespace glider::frontend {

namespace {

/// Whether the first of two arguments is a number, and the second is not.
bool numberFirst(const ast::Invocation& node) {
  const auto written = [](const ast::Argument& argument) {
    return std::holds_alternative<ast::Literal>(argument.value->node);
  };
  return written(node.arguments.front()) && !written(node.arguments.back());
}

}  // namespace

/// `mean(5 min, temp)`: the value and the length of its window turned round.
bool ExprLowering::lengthFirst(const ast::Invocation& node) {
  const ast::Argument& length = node.arguments.front();
  const ast::Argument& watched = node.arguments.back();
  if (!numberFirst(node) || watched.of || legOf(*watched.value)) {
    return false;
  }
  const Result value = lower(*watched.value, std::nullopt);
  const ir::Type time = quantity(support::dimension::time);
  if (!value || value->type == time) {
    return !value;
  }
  const Result over = length.of ? lower(*length.value, std::nullopt) : std::nullopt;
  const std::string first =
      scope_.text(length.value->where) + (length.of ? " of " + length.of->text : "");
  const std::string second = scope_.text(watched.value->where);
  const support::SourceRange& from = length.value->where;
  const std::string& function = node.function.text;
  scope_
      .report(support::diagnostics::wrongType, watched.value->where,
              fmt::format("the length of `{}`", function), describe(over ? over->type : time),
              second, describe(value->type), "")
      .hint(fmt::format("the value comes first: write `{}({}, {})`", function, second, first))
      .fix({from.file, from.begin, watched.value->where.end}, fmt::format("{}, {}", second, first));
  return true;
}

/// `held(30 s, temp > 20 degC)`: refused once, not as two arguments.
bool ExprLowering::timeFirst(const ast::Invocation& node) {
  const ast::Expr& time = *node.arguments.front().value;
  const ast::Expr& condition = *node.arguments.back().value;
  if (!numberFirst(node)) {
    return false;
  }
  const Result value = lower(time, std::nullopt);
  if (value) {
    const std::string first = scope_.text(time.where);
    const std::string second = scope_.text(condition.where);
    scope_.report(support::diagnostics::notACondition, time.where, first, describe(value->type))
        .hint(fmt::format("the condition comes first: write `held({}, {})`", second, first))
        .fix(time.where, second)
        .fix(condition.where, first);
  }
  return true;
}

/// `became(g)` and `held(g, 30 s)`.
ExprLowering::Result ExprLowering::overTime(ir::TemporalKind kind, const ast::Invocation& node,
                                            const ast::Expr& expr) {
  const bool held = kind == ir::TemporalKind::Held;
  if (!scope_.context.list) {
    scope_.refuseOverTime(expr.where, node.function.text);
    return std::nullopt;
  }
  const size_t wanted = held ? 2 : 1;
  const auto fits = [wanted](const std::vector<ast::Argument>& read) {
    return read.size() == wanted;
  };
  if (!fits(node.arguments) && refuseDecimalCommas(node.arguments, scope_, fits)) {
    return std::nullopt;
  }
  if (!fits(node.arguments)) {
    scope_.report(support::diagnostics::wrongArgumentCount, expr.where, node.function.text,
                  held ? "2 arguments" : "1 argument",
                  node.arguments.empty() ? "none"
                                         : fmt::format("{} argument{}", node.arguments.size(),
                                                       node.arguments.size() == 1 ? "" : "s"),
                  held ? "held(condition, 30 s)" : "became(condition)");
    return std::nullopt;
  }
  if (held && timeFirst(node)) {
    return std::nullopt;
  }
  ir::Temporal temporal;
  temporal.kind = kind;
  temporal.list = *scope_.context.list;
  temporal.state = scope_.context.state;
  temporal.range = expr.where;
  const auto operand = lowerCondition(*node.arguments.front().value);
  if (held) {
    const ast::Expr& time = *node.arguments.back().value;
    const auto duration = lowerAs(time, quantity(support::dimension::time), "the time of `held`");
    if (!duration) {
      return std::nullopt;
    }
    const auto known = evaluate(scope_.mission, *duration);
    if (known && !(*known > 0)) {
      scope_.report(support::diagnostics::heldNotPositive, time.where, scope_.text(time.where));
      return std::nullopt;
    }
    temporal.duration = *duration;
  }
  if (!operand) {
    return std::nullopt;
  }
  temporal.operand = *operand;
  return watch(temporal);
}

}  // namespace glider::frontend
