// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/literals.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

// Magnetic headings: `90 deg magnetic`, `magnetic(course)`. All values are true headings, so these
// take off the variation by which the runtime will make them magnetic again (runtime/core/compass):
// the last that the vehicle has reported, until then that of the `declination` line, without a line
// 0. So `heading(90 deg magnetic)` is 90 deg on the vehicle's compass for any variation,
// and is never unknown. `heading > 90 deg magnetic` compares what the compass shows: the order of
// true headings is another one, as they begin again at true north.

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

ir::ExprId ExprLowering::wrapped(ir::ExprId sum, const support::SourceRange& range) {
  const ir::Type angle = quantity(support::dimension::angle);
  const ir::ExprId zero = emitNumber(0, angle, range).id;
  const ir::ExprId turn = emitNumber(kFullTurn, angle, range).id;
  const auto choose = [&](ir::Op op, ir::ExprId limit, ir::Op change, ir::ExprId value) {
    const ir::ExprId beyond = emit(op, boolean(), range, {value, limit}).id;
    const ir::ExprId changed = emit(change, angle, range, {value, turn}).id;
    return emit(ir::Op::Select, angle, range, {beyond, changed, value}).id;
  };
  // In this order: a sum just below 0 is rounded up to a full turn, which is 0.
  const ir::ExprId positive = choose(ir::Op::Less, zero, ir::Op::Add, sum);
  return choose(ir::Op::GreaterEqual, turn, ir::Op::Subtract, positive);
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
  const ir::Type angle = quantity(support::dimension::angle);
  const ir::ExprId variation = variationInForce(range)->id;
  const ir::ExprId plain = emit(ir::Op::Subtract, angle, range, {heading, variation}).id;
  Value result = valueOf(wrapped(plain, range));
  result.on_compass = heading;
  return result;
}

ir::ExprId ExprLowering::onCompass(const Value& heading, const support::SourceRange& range) {
  if (heading.on_compass.valid()) {
    return heading.on_compass;
  }
  const ir::Type angle = quantity(support::dimension::angle);
  const ir::ExprId variation = variationInForce(range)->id;
  // Where the compass shows 0, the runtime has made (2 pi - v) of it, rounded by at most half a
  // unit in the last place of 2 pi, which is even: with v added, the sum rounds to 2 pi, and that
  // is 0.
  return wrapped(emit(ir::Op::Add, angle, range, {heading.id, variation}).id, range);
}

void ExprLowering::compareOnCompass(ir::Op op, Pair& pair, const ast::Binary& node) {
  const bool orders = op != ir::Op::Equal && op != ir::Op::NotEqual;
  if (!orders || (!pair.left.on_compass.valid() && !pair.right.on_compass.valid())) {
    return;
  }
  pair.left.id = onCompass(pair.left, node.left->where);
  pair.right.id = onCompass(pair.right, node.right->where);
}

}  // namespace glider::frontend
