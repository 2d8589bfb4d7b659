// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/naps/course.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"

namespace glider::ir {
namespace {

bool changesByItself(const Expr& e) {
  switch (groupOf(e.op)) {
    case OpGroup::Clock:
    case OpGroup::Sensor:
    case OpGroup::Temporal:
    case OpGroup::Age:
    case OpGroup::Call:
      return true;
    case OpGroup::Constant:
    case OpGroup::Truth:
    case OpGroup::Variable:
    case OpGroup::Unary:
    case OpGroup::Binary:
    case OpGroup::Function:
    case OpGroup::Clamp:
    case OpGroup::Select:
    case OpGroup::Element:
    case OpGroup::Comparison:
    case OpGroup::Known:
    case OpGroup::Logic:
      break;
  }
  return false;
}

Course turned(Course course) {
  return course == Course::Rises ? Course::Falls : course == Course::Falls ? Course::Rises : course;
}

Course sum(Course a, Course b) {
  return a == Course::Fixed ? b : b == Course::Fixed ? a : Course::Reading;
}

}  // namespace

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Course courseOf(const Mission& mission, ExprId id) {
  const Expr& e = mission[id];
  if (!anyIn(mission, id, changesByItself)) {
    return Course::Fixed;
  }
  if (groupOf(e.op) == OpGroup::Clock) {
    return Course::Rises;
  }
  if (e.op == Op::Negate) {
    return turned(courseOf(mission, e.operands[0]));
  }
  if (e.op == Op::Add || e.op == Op::Subtract) {
    const Course right = courseOf(mission, e.operands[1]);
    return sum(courseOf(mission, e.operands[0]), e.op == Op::Add ? right : turned(right));
  }
  return Course::Reading;
}

}  // namespace glider::ir
