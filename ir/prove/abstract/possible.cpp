// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/possible.h"

#include <algorithm>
#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();

Truths exactly(bool value) {
  return {value, !value, false};
}

Truths both(const Truths& a, const Truths& b) {
  return {a.is_true && b.is_true, a.is_false || b.is_false,
          (a.is_unknown && (b.is_unknown || b.is_true)) || (b.is_unknown && a.is_true)};
}

Truths negated(const Truths& a) {
  return {a.is_false, a.is_true, a.is_unknown};
}

}  // namespace

Holding anything(const Variable& variable) {
  Holding all;
  all.lowest = std::max(variable.lowest, -kMost);
  all.highest = std::min(variable.highest, kMost);
  return all;
}

Holding withinRange(Holding holding, const Variable& variable) {
  holding.lowest = std::max(holding.lowest, variable.lowest);
  holding.highest = std::min(holding.highest, variable.highest);
  holding.never = holding.never || holding.lowest > holding.highest;
  if (holding.never) {
    holding.lowest = holding.highest = 0;
  }
  return holding;
}

Holding either(const Holding& a, const Holding& b) {
  Holding all = a;
  if (!b.never) {
    all.lowest = a.never ? b.lowest : std::min(a.lowest, b.lowest);
    all.highest = a.never ? b.highest : std::max(a.highest, b.highest);
    all.never = false;
  }
  all.truths = {a.truths.is_true || b.truths.is_true, a.truths.is_false || b.truths.is_false,
                a.truths.is_unknown || b.truths.is_unknown};
  return all;
}

Possible::Possible(const Ground& ground, const Valuation& values, const ClockRanges& clocks)
    : ground_(ground), values_(values) {
  const Mission& m = ground.mission;
  numbers_ = intervalsOf(m, [&](const Expr& e) -> std::optional<Interval> {
    switch (e.op) {
      case Op::MissionTime:
        return clocks.mission_time;
      case Op::StateTime:
        return clocks.state_time;
      case Op::ResumeTime:
        return clocks.resume_time;
      case Op::Variable: {
        const Holding& held = values[e.variable.index];
        return Interval{held.lowest, held.highest, held.never};
      }
      case Op::Temporal:  // a window holds what was before this moment too
        return ground.windows[e.temporal.index];
      default:
        return std::nullopt;
    }
  });
  truths_.reserve(m.exprs.size());
  for (uint32_t i = 0; i < m.exprs.size(); ++i) {
    const bool truth = m.exprs[i].type.kind == TypeKind::Bool;
    truths_.push_back(truth ? judge(m.exprs[i], i) : Truths{});
  }
}

const Truths& Possible::operand(const Expr& e, size_t i) const {
  return truths_[e.operands.at(i).index];
}

bool Possible::maybeUnknown(ExprId id) const {
  return !ground_.known.expressions[id.index];
}

Holding Possible::holding(ExprId id) const {
  const Interval& x = numbers_[id.index];
  return {x.lowest, x.highest, x.empty, truths_[id.index]};
}

Truths Possible::judge(const Expr& e, uint32_t index) const {
  Truths result;
  switch (e.op) {
    case Op::True:
    case Op::False:
      return exactly(e.op == Op::True);
    case Op::Variable:
      result = values_[e.variable.index].truths;
      break;
    case Op::Not:
      result = negated(operand(e, 0));
      break;
    case Op::And:
      result = both(operand(e, 0), operand(e, 1));
      break;
    case Op::Or:
      result = negated(both(negated(operand(e, 0)), negated(operand(e, 1))));
      break;
    case Op::Known:
      return {true, !ground_.known.expressions[e.operands[0].index], false};
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual:
      result = compared(e);
      break;
    default:
      break;
  }
  result.is_unknown = result.is_unknown && !ground_.known.expressions[index];
  return result;
}

/// Of two numbers; not of (in)equality, which is rarely of use.
Truths Possible::compared(const Expr& e) const {
  const bool turned = e.op == Op::Greater || e.op == Op::GreaterEqual;
  const Interval& a = numbers_[e.operands[turned ? 1 : 0].index];
  const Interval& b = numbers_[e.operands[turned ? 0 : 1].index];
  const bool unknown = maybeUnknown(e.operands[0]) || maybeUnknown(e.operands[1]);
  if (a.empty || b.empty) {
    return {false, false, true};
  }
  const bool strict = e.op == Op::Less || e.op == Op::Greater;
  return strict ? Truths{a.lowest < b.highest, a.highest >= b.lowest, unknown}
                : Truths{a.lowest <= b.highest, a.highest > b.lowest, unknown};
}

}  // namespace glider::ir::prove
