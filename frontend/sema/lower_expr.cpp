// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/lower_expr.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::frontend {

using support::DiagnosticId;

std::optional<Value> ExprLowering::lower(const ast::Expr& expr, std::optional<ir::Type> want) {
  return std::visit([&](const auto& node) { return visit(node, expr, want); }, expr.node);
}

std::optional<ir::ExprId> ExprLowering::lowerAs(const ast::Expr& expr, const ir::Type& want,
                                                const std::string& what) {
  const Result value = lower(expr, want);
  if (!value) {
    return std::nullopt;
  }
  if (value->longitude.valid() || value->type != want) {
    scope_.report(DiagnosticId::wrongType, expr.where, what, describe(want),
                  scope_.text(expr.where),
                  value->longitude.valid() ? "a position" : describe(value->type));
    return std::nullopt;
  }
  return value->id;
}

std::optional<ir::ExprId> ExprLowering::lowerCondition(const ast::Expr& expr) {
  const Result value = lower(expr, std::nullopt);
  if (!value) {
    return std::nullopt;
  }
  if (value->longitude.valid() || value->type != boolean()) {
    scope_.report(DiagnosticId::notACondition, expr.where, scope_.text(expr.where),
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

ExprLowering::Result ExprLowering::visit(const ast::List&, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  scope_.notYet(expr.where, "a list of positions");
  return std::nullopt;
}

ExprLowering::Result ExprLowering::visit(const ast::Index&, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  scope_.notYet(expr.where, "picking from a list with `[`");
  return std::nullopt;
}

ExprLowering::Result ExprLowering::clock(Clock clock, const support::SourceRange& range) {
  constexpr ir::Op kOps[] = {ir::Op::MissionTime, ir::Op::StateTime, ir::Op::ResumeTime};
  return emit(kOps[static_cast<size_t>(clock)], quantity(support::dimension::time), range, {});
}

ExprLowering::Result ExprLowering::constant(const Constant& constant,
                                            const support::SourceRange& range) {
  if (!constant.valid) {
    return std::nullopt;
  }
  if (constant.type.kind == ir::TypeKind::Bool) {
    return emit(constant.number != 0 ? ir::Op::True : ir::Op::False, boolean(), range, {});
  }
  Value value = emitNumber(constant.number, constant.type, range);
  if (constant.position) {
    value.longitude = emitNumber(constant.second, {ir::TypeKind::Longitude, {}}, range).id;
  }
  return value;
}

ExprLowering::Result ExprLowering::visit(const ast::NameUse& node, const ast::Expr& expr,
                                         std::optional<ir::Type>) {
  if (const auto found = scope_.constants.find(node.name); found != scope_.constants.end()) {
    if (!found->second.worked_out) {
      scope_.report(DiagnosticId::usedBeforeDefined, expr.where, node.name)
          .note(found->second.name->where, "it is defined here");
      return std::nullopt;
    }
    return constant(found->second, expr.where);
  }
  if (const auto which = findClock(node.name)) {
    return clock(*which, expr.where);
  }
  if (const platforms::PlatformSensor* sensor = scope_.platform().find(node.name)) {
    const ir::SensorId id = scope_.subscribe(*sensor, node.name);
    reads_.push_back({sensor, node.name, expr.where});
    const ir::Type type = scope_.mission[id].type;
    const Value value = emit(ir::Op::Sensor, type, expr.where, {});
    scope_.mission.exprs[value.id.index].sensor = id;
    return value;
  }
  if (scope_.later_values.contains(node.name)) {
    return std::nullopt;  // its declaration was refused
  }
  if (node.name == "profiledone" || node.name == "routedone") {
    scope_.notYet(expr.where, "`" + node.name + "`");
    return std::nullopt;
  }
  const bool behaviour = scope_.behaviours.contains(node.name);
  const std::string hint = scope_.states.contains(node.name)
                               ? "`" + node.name + "` is a state: only `goto` and `call` take it"
                           : behaviour
                               ? "`" + node.name + "` says how the vehicle flies; it has no value"
                               : scope_.suggestName(node.name);
  scope_.report(DiagnosticId::unknownName, expr.where, node.name, hint);
  return std::nullopt;
}

}  // namespace glider::frontend
