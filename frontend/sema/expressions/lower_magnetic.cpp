// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <numbers>

// Magnetic headings: `90 deg magnetic`, `magnetic(course)`. All values are true headings, so these
// take off the variation by which the runtime will make them magnetic again (runtime/core/compass):
// the last that the vehicle has reported, until then that of the `declination` line, without a line
// 0. So `heading(90 deg magnetic)` is 90 deg on the vehicle's compass for any variation,
// and is never unknown.

namespace glider::frontend {

ExprLowering::Result ExprLowering::magnetic(const ast::Invocation& node, const ast::Expr& expr) {
  if (node.arguments.size() != 1) {
    scope_.report(support::diagnostics::wrongArgumentCount, expr.where, node.function.text,
                  "1 argument", node.arguments.empty() ? "none" : "more", "magnetic(90 deg)");
    return std::nullopt;
  }
  const auto angle = lowerAs(*node.arguments.front().value, quantity(support::dimension::angle),
                             "the argument of `magnetic`");
  return angle ? fromMagnetic(*angle, expr.where) : std::nullopt;
}

/// The magnetic variation that the runtime uses in this tick.
ExprLowering::Result ExprLowering::variationInForce(const support::SourceRange& range) {
  const ir::Type angle = quantity(support::dimension::angle);
  const Value assumed = emitNumber(-scope_.declination.value_or(0), angle, range);
  const platforms::PlatformSensor* reported = scope_.platform().find(platforms::kVariationSensor);
  if (reported == nullptr) {
    return assumed;
  }
  // Not a use of the sensor that the mission should list.
  const ir::SensorId id = scope_.subscribe(*reported, reported->name);
  const ir::ExprId reading = ir::MissionWriter(scope_.mission, range).read(id);
  const Value known = emit(ir::Op::Known, boolean(), range, {reading});
  return emit(ir::Op::Select, angle, range, {known.id, reading, assumed.id});
}

ExprLowering::Result ExprLowering::fromMagnetic(ir::ExprId heading,
                                                const support::SourceRange& range) {
  if (!scope_.context.constant.empty()) {
    scope_
        .report(support::diagnostics::notConstant, range, scope_.text(range),
                scope_.context.constant)
        .hint("use it where the heading is given: `heading(90 deg magnetic)`");
    return std::nullopt;
  }
  constexpr double kTurn = 2 * std::numbers::pi;
  const ir::Type angle = quantity(support::dimension::angle);
  const auto number = [&](double value) { return emitNumber(value, angle, range).id; };
  const auto choose = [&](ir::ExprId condition, ir::ExprId a, ir::ExprId b) {
    return emit(ir::Op::Select, angle, range, {condition, a, b}).id;
  };
  const ir::ExprId variation = variationInForce(range)->id;
  const ir::ExprId plain = emit(ir::Op::Subtract, angle, range, {heading, variation}).id;
  const ir::ExprId below = emit(ir::Op::Less, boolean(), range, {plain, number(0)}).id;
  const ir::ExprId above = emit(ir::Op::GreaterEqual, boolean(), range, {plain, number(kTurn)}).id;
  const ir::ExprId more = emit(ir::Op::Add, angle, range, {plain, number(kTurn)}).id;
  const ir::ExprId less = emit(ir::Op::Subtract, angle, range, {plain, number(kTurn)}).id;
  return valueOf(choose(below, more, choose(above, less, plain)));
}

}  // namespace glider::frontend
