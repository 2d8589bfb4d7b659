// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"

#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

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
    const MissingUnit constant = missingUnitOf(expr, want);
    if (!constant.reported) {
      auto report = scope_.report(support::diagnostics::wrongType, expr.where, what, describe(want),
                                  scope_.text(expr.where), describe(given), howToWrite(want));
      constant.explain(report);
    }
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

Value ExprLowering::watch(const ir::Temporal& temporal) {
  scope_.mission.temporals.push_back(temporal);
  const ir::TemporalId id{static_cast<uint32_t>(scope_.mission.temporals.size() - 1)};
  return valueOf(ir::MissionWriter(scope_.mission, temporal.range).read(id));
}

Value ExprLowering::emit(ir::Op op, const ir::Type& type, const support::SourceRange& range,
                         std::initializer_list<ir::ExprId> operands) {
  return {ir::MissionWriter(scope_.mission, range).operation(op, type, operands), type, {}};
}

Value ExprLowering::emitOf(ir::Op op, const support::SourceRange& range,
                           std::span<const ir::ExprId> operands) {
  return valueOf(ir::MissionWriter(scope_.mission, range).operation(op, operands));
}

Value ExprLowering::emitNumber(double value, const ir::Type& type,
                               const support::SourceRange& range) {
  return {ir::MissionWriter(scope_.mission, range).number(value, type), type, {}};
}

ExprLowering::Result ExprLowering::visit(const ast::Truth& node, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  return emit(node.value ? ir::Op::True : ir::Op::False, boolean(), expr.where, {});
}

}  // namespace glider::frontend
