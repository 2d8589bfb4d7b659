// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"

#include "ir/core/ops.h"
#include "support/check.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::frontend {

std::optional<Value> ExprLowering::lower(const ast::Expr& expr, std::optional<ir::Type> want) {
  return std::visit([&](const auto& node) { return visit(node, expr, want); }, expr.node);
}

std::optional<ir::ExprId> ExprLowering::lowerAs(const ast::Expr& expr, const ir::Type& want,
                                                const std::string& what) {
  const Result value = lowerDeclared(expr, {want, false}, what);
  return value ? std::optional(value->id) : std::nullopt;
}

std::optional<Value> ExprLowering::lowerDeclared(const ast::Expr& expr, const DeclaredType& want,
                                                 const std::string& what) {
  const Result value = lower(expr, want.position ? std::nullopt : std::optional(want.type));
  if (!value) {
    return std::nullopt;
  }
  const DeclaredType given{value->type, value->longitude.valid()};
  if (given != want) {
    scope_.report(support::diagnostics::wrongType, expr.where, what, describe(want),
                  scope_.text(expr.where), describe(given), howToWrite(want));
    return std::nullopt;
  }
  return value;
}

std::optional<ir::ExprId> ExprLowering::lowerCondition(const ast::Expr& expr) {
  const Result value = lower(expr, std::nullopt);
  if (!value) {
    return std::nullopt;
  }
  if (value->longitude.valid() || value->type != boolean()) {
    scope_.report(support::diagnostics::notACondition, expr.where, scope_.text(expr.where),
                  value->longitude.valid() ? "a position" : describe(value->type));
    return std::nullopt;
  }
  return value->id;
}

ir::ExprId ExprLowering::push(ir::Expr expr) {
  scope_.mission.exprs.push_back(expr);
  return {static_cast<uint32_t>(scope_.mission.exprs.size() - 1)};
}

Value ExprLowering::emit(ir::Op op, const ir::Type& type, const support::SourceRange& range,
                         std::initializer_list<ir::ExprId> operands) {
  ir::Expr expr;
  expr.op = op;
  expr.type = type;
  expr.range = range;
  std::ranges::copy(operands, expr.operands.begin());
  return {push(expr), type, {}};
}

Value ExprLowering::emitOf(ir::Op op, const support::SourceRange& range,
                           std::span<const ir::ExprId> operands) {
  ir::Expr expr;
  expr.op = op;
  expr.range = range;
  std::ranges::copy(operands, expr.operands.begin());
  const auto type = ir::resultType(scope_.mission, expr);
  CHECK(type, "operands that an operation does not take");
  expr.type = *type;
  return {push(expr), *type, {}};
}

Value ExprLowering::emitNumber(double value, const ir::Type& type,
                               const support::SourceRange& range) {
  ir::Expr expr;
  expr.op = ir::Op::Constant;
  expr.type = type;
  expr.number = value;
  expr.range = range;
  return {push(expr), type, {}};
}

ExprLowering::Result ExprLowering::visit(const ast::Truth& node, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  return emit(node.value ? ir::Op::True : ir::Op::False, boolean(), expr.where, {});
}

}  // namespace glider::frontend
