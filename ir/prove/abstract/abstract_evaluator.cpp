// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/abstract_evaluator.h"

#include "ir/core/ops.h"
#include "support/check.h"

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

Interval rangeOf(ClockOp clock, const ClockRanges& clocks) {
  switch (clock) {
    case ClockOp::MissionTime:
      return clocks.mission_time;
    case ClockOp::StateTime:
      return clocks.state_time;
    case ClockOp::ResumeTime:
      return clocks.resume_time;
  }
  CHECK(false, "a clock without a range");
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

AbstractEvaluator::AbstractEvaluator(const ProofContext& proof_context, const Valuation& values,
                                     const ClockRanges& clocks)
    : proof_context_(proof_context), values_(values) {
  const Mission& m = proof_context.mission;
  numbers_ = intervalsOf(m, [&](const Expr& e) -> std::optional<Interval> {
    if (groupOf(e.op) == OpGroup::Clock) {
      return rangeOf(opIn<ClockOp>(e.op), clocks);
    }
    if (e.op == Op::Variable) {
      const Holding& held = values[e.variable.index];
      return Interval{held.lowest, held.highest, held.never};
    }
    // A window also contains values from before this moment.
    return e.op == Op::Temporal ? std::optional(proof_context.windows[e.temporal.index])
                                : std::nullopt;
  });
  truths_.reserve(m.exprs.size());
  for (uint32_t i = 0; i < m.exprs.size(); ++i) {
    const bool truth = m.exprs[i].type.kind == TypeKind::Bool;
    truths_.push_back(truth ? judge(m.exprs[i], i) : Truths{});
  }
}

const Truths& AbstractEvaluator::operand(const Expr& e, size_t i) const {
  return truths_[e.operands.at(i).index];
}

bool AbstractEvaluator::maybeUnknown(ExprId id) const {
  return !proof_context_.known.expressions[id.index];
}

Holding AbstractEvaluator::holding(ExprId id) const {
  const Interval& x = numbers_[id.index];
  return {x.lowest, x.highest, x.empty, truths_[id.index]};
}

Truths AbstractEvaluator::judge(const Expr& e, uint32_t index) const {
  Truths result;
  if (groupOf(e.op) == OpGroup::Truth) {
    return exactly(e.op == Op::True);
  }
  if (e.op == Op::Known) {
    return {true, !proof_context_.known.expressions[e.operands[0].index], false};
  }
  if (e.op == Op::Variable) {
    result = values_[e.variable.index].truths;
  } else if (groupOf(e.op) == OpGroup::Logic) {
    result = logic(e);
  } else if (isOrdering(e.op)) {
    result = compared(e);
  }
  result.is_unknown = result.is_unknown && !proof_context_.known.expressions[index];
  return result;
}

/// For two numbers; not for (in)equality, which is rarely of use.
Truths AbstractEvaluator::logic(const Expr& e) const {
  switch (opIn<LogicOp>(e.op)) {
    case LogicOp::Not:
      return negated(operand(e, 0));
    case LogicOp::And:
      return both(operand(e, 0), operand(e, 1));
    case LogicOp::Or:
      return negated(both(negated(operand(e, 0)), negated(operand(e, 1))));
  }
  CHECK(false, "a word of logic without a meaning");
}

Truths AbstractEvaluator::compared(const Expr& e) const {
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
