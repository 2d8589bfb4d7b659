// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/naps/wake_of_truth.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/naps/course.h"
#include "ir/naps/wake_tree.h"

#include <utility>

namespace glider::ir {
namespace {

/// Whether it is a variable that a statement may set. What a temporal watches was compared before
/// the statements of the tick ran: it may change in the next tick without any other cause.
bool maySet(const Mission& mission, const Expr& e) {
  if (e.op != Op::Variable) {
    return false;
  }
  const VariableKind kind = mission[e.variable].kind;
  return kind != VariableKind::Parameter && kind != VariableKind::Argument;
}

}  // namespace

Wake WakeOfTruth::becomes(ExprId id, bool value) {
  return of(id, value, false);
}

Wake WakeOfTruth::leaves(ExprId id, bool value) {
  return of(id, value, true);
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Wake WakeOfTruth::changes(ExprId id) {
  return branch(id, false, leaves(id, true),
                branch(id, true, leaves(id, false), both(becomes(id, true), becomes(id, false))));
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Wake WakeOfTruth::of(ExprId id, bool value, bool leaves) {
  const Expr& e = mission_[id];
  if (left_ == 0) {
    return awake(e.range);
  }
  --left_;
  if (courseOf(mission_, id) == Course::Fixed) {
    return {};
  }
  const OpGroup group = groupOf(e.op);
  return group == OpGroup::Logic        ? logic(e, value, leaves)
         : group == OpGroup::Comparison ? comparison(e, leaves)
         : group == OpGroup::Known      ? known(e, value, leaves)
         : group == OpGroup::Temporal   ? temporal(id, value, leaves)
                                        : awake(e.range);
}

/// `and` is true if both sides are: it becomes true only if one that is not does, whichever, and
/// leaves that if one of them does. `or` likewise, with false for true.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Wake WakeOfTruth::logic(const Expr& e, bool value, bool leaves) {
  const ExprId a = e.operands[0];
  if (e.op == Op::Not) {
    return of(a, !value, leaves);
  }
  const ExprId b = e.operands[1];
  const bool needs_both = (e.op == Op::And) == value;
  if (needs_both == leaves) {
    return both(of(a, value, leaves), of(b, value, leaves));
  }
  // Needs both: of one that is missing. Needs one: of one that is there.
  Wake of_a = of(a, value, leaves);
  Wake of_b = of(b, value, leaves);
  return leaves ? branch(a, !value, std::move(of_a), std::move(of_b))
                : branch(a, !value, std::move(of_b), std::move(of_a));
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Wake WakeOfTruth::comparison(const Expr& e, bool leaves) {
  return comparison(e.operands[0], e.operands[1], e.range, leaves);
}

Wake WakeOfTruth::comparison(ExprId left, ExprId right, support::SourceRange range, bool leaves) {
  const Course of_left = courseOf(mission_, left);
  const Course of_right = courseOf(mission_, right);
  if (of_left != Course::Reading && of_right != Course::Reading) {
    return clocks(left, right, range);
  }
  const bool sensor_is_left = of_right == Course::Fixed;
  const Expr& reading = mission_[sensor_is_left ? left : right];
  if ((!sensor_is_left && of_left != Course::Fixed) || reading.op != Op::Sensor) {
    return awake(range);
  }
  Wake crossed = ofSensor(WakeKind::Crossed, reading.sensor, sensor_is_left ? right : left);
  return leaves ? both(std::move(crossed), ofSensor(WakeKind::Lost, reading.sensor))
                : std::move(crossed);
}

Wake WakeOfTruth::clocks(ExprId left, ExprId right, support::SourceRange range) {
  const Course of_left = courseOf(mission_, left);
  const Course of_right = courseOf(mission_, right);
  if (of_left != Course::Fixed && of_right != Course::Fixed) {
    return awake(range);
  }
  const bool left_rises = of_left == Course::Rises || of_right == Course::Falls;
  return left_rises ? until(left, right) : until(right, left);
}

Wake WakeOfTruth::known(const Expr& e, bool value, bool leaves) {
  const Expr& operand = mission_[e.operands[0]];
  if (operand.op != Op::Sensor) {
    return awake(e.range);
  }
  return ofSensor(value == leaves ? WakeKind::Lost : WakeKind::Known, operand.sensor);
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Wake WakeOfTruth::temporal(ExprId id, bool value, bool leaves) {
  const Expr& e = mission_[id];
  const Temporal& temporal = mission_[e.temporal];
  const auto set = [&](const Expr& part) { return maySet(mission_, part); };
  if (anyIn(mission_, temporal.operand, set) ||
      (temporal.duration.valid() && anyIn(mission_, temporal.duration, set))) {
    return awake(e.range);
  }
  if (temporal.kind == TemporalKind::Became) {
    return became(id, temporal, value, leaves);
  }
  return temporal.kind == TemporalKind::Held ? held(id, temporal, value, leaves) : awake(e.range);
}

/// It is true for one tick only. While it is not, its operand is what it was, and it becomes true
/// after that has changed.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Wake WakeOfTruth::became(ExprId id, const Temporal& temporal, bool value, bool leaves) {
  if (value && leaves) {
    return awake(mission_[id].range);
  }
  return branch(id, false, awake(mission_[id].range), changes(temporal.operand));
}

/// While its operand is true it waits for a time that is not among the expressions.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Wake WakeOfTruth::held(ExprId id, const Temporal& temporal, bool value, bool leaves) {
  const support::SourceRange range = mission_[id].range;
  if (courseOf(mission_, temporal.duration) != Course::Fixed) {
    return awake(range);
  }
  Wake of_true = this->leaves(temporal.operand, true);
  if (value && leaves) {
    return of_true;
  }
  Wake of_operand = changes(temporal.operand);
  if (!value && !leaves) {
    return branch(id, false, std::move(of_true), std::move(of_operand));
  }
  return branch(temporal.operand, false, awake(range), std::move(of_operand));
}

}  // namespace glider::ir
