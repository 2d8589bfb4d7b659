// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/abstract_evaluator.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/verify/intervals.h"
#include "support/check.h"

#include <algorithm>

namespace glider::ir::prove {
namespace {

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

PossibleValues anything(const Variable& variable) {
  PossibleValues all;
  all.lowest = std::max(variable.lowest, -kGreatestNumber);
  all.highest = std::min(variable.highest, kGreatestNumber);
  return all;
}

PossibleValues withinRange(PossibleValues holding, const Variable& variable) {
  holding.lowest = std::max(holding.lowest, variable.lowest);
  holding.highest = std::min(holding.highest, variable.highest);
  holding.never = holding.never || holding.lowest > holding.highest;
  if (holding.never) {
    holding.lowest = holding.highest = 0;
  }
  return holding;
}

PossibleValues either(const PossibleValues& a, const PossibleValues& b) {
  PossibleValues all = a;
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
                                     const ClockRanges& clocks, std::optional<AssumedReading> sight,
                                     const IdleTemporals* idle)
    : proof_context_(proof_context), values_(values), clocks_(clocks), sight_(sight), idle_(idle) {}

const AbstractEvaluator::Evaluated& AbstractEvaluator::operand(const Expr& e, size_t i) const {
  return made_.at(e.operands.at(i).index);
}

/// Without recursion, at any depth: what an expression reads has a smaller id.
const AbstractEvaluator::Evaluated& AbstractEvaluator::at(ExprId id) const {
  if (const auto found = made_.find(id.index); found != made_.end()) {
    return found->second;
  }
  const Mission& m = proof_context_.mission;
  std::vector<uint32_t>& open = open_;
  open.assign(1, id.index);
  while (!open.empty()) {
    const uint32_t index = open.back();
    const Expr& e = m.exprs[index];
    const size_t before = open.size();
    for (uint32_t k = 0; k < operandCount(e); ++k) {
      if (!made_.contains(e.operands.at(k).index)) {
        open.push_back(e.operands.at(k).index);
      }
    }
    if (e.op == Op::Temporal && !isWindow(m[e.temporal].kind) &&
        !made_.contains(m[e.temporal].operand.index)) {
      open.push_back(m[e.temporal].operand.index);
    }
    if (open.size() == before) {
      open.pop_back();
      if (!made_.contains(index)) {
        made_.emplace(index, make(index));
      }
    }
  }
  return made_.at(id.index);
}

std::optional<Interval> AbstractEvaluator::leaf(const Expr& e) const {
  if (groupOf(e.op) == OpGroup::Clock) {
    return rangeOf(opIn<ClockOp>(e.op), clocks_);
  }
  if (e.op == Op::Variable) {
    const PossibleValues& held = values_[e.variable.index];
    return Interval{held.lowest, held.highest, held.never};
  }
  if (e.op == Op::Sensor && sight_ && e.sensor == sight_->sensor) {
    return sight_->reading;
  }
  return e.op == Op::Temporal ? std::optional(window(e.temporal)) : std::nullopt;
}

/// A window also contains values from before this moment.
Interval AbstractEvaluator::window(TemporalId id) const {
  const Temporal& temporal = proof_context_.mission[id];
  const Expr& operand = proof_context_.mission[temporal.operand];
  const bool one_of_them =
      temporal.kind == TemporalKind::Lowest || temporal.kind == TemporalKind::Highest;
  const bool seen = one_of_them && sight_ && sight_->ever && operand.op == Op::Sensor &&
                    operand.sensor == sight_->sensor;
  Interval range = seen ? sight_->reading : proof_context_.windows[id.index];
  range.empty = range.empty || isIdle(id);
  return range;
}

AbstractEvaluator::Evaluated AbstractEvaluator::make(uint32_t index) const {
  const Mission& m = proof_context_.mission;
  const Expr& e = m.exprs[index];
  Evaluated made;
  made.number = intervalOf(
      m, index, [&](const Expr& x) { return leaf(x); },
      [&](uint32_t i) -> const Interval& { return made_.at(i).number; });
  made.truths = e.type.kind == TypeKind::Bool ? judge(e, index) : Truths{};
  return made;
}

bool AbstractEvaluator::maybeUnknown(ExprId id) const {
  return !proof_context_.known.expressions[id.index];
}

PossibleValues AbstractEvaluator::holding(ExprId id) const {
  const Evaluated& made = at(id);
  return {made.number.lowest, made.number.highest, made.number.empty, made.truths};
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
  } else if (e.op == Op::Temporal) {
    result = watched(proof_context_.mission[e.temporal]);
    result.is_true = result.is_true && !isIdle(e.temporal);
  } else if (groupOf(e.op) == OpGroup::Logic) {
    result = logic(e);
  } else if (isOrdering(e.op)) {
    result = compared(e);
  }
  result.is_unknown = result.is_unknown && !proof_context_.known.expressions[index];
  return result;
}

/// `became` and `held` are true only on a tick that began with their operand true (B2, B5).
/// Readings and mission time are the same from then on until the tick is over; the other clocks and
/// the variables may have changed since.
Truths AbstractEvaluator::watched(const Temporal& temporal) const {
  Truths all;
  const bool same = !anyIn(proof_context_.mission, temporal.operand, [](const Expr& e) {
    return e.op == Op::Variable || e.op == Op::StateTime || e.op == Op::ResumeTime ||
           e.op == Op::Temporal || e.op == Op::Call;
  });
  all.is_true = !same || made_.at(temporal.operand.index).truths.is_true;
  return all;
}

/// For two numbers; not for (in)equality, which is rarely of use.
Truths AbstractEvaluator::logic(const Expr& e) const {
  switch (opIn<LogicOp>(e.op)) {
    case LogicOp::Not:
      return negated(operand(e, 0).truths);
    case LogicOp::And:
      return both(operand(e, 0).truths, operand(e, 1).truths);
    case LogicOp::Or:
      return negated(both(negated(operand(e, 0).truths), negated(operand(e, 1).truths)));
  }
  CHECK(false, "a word of logic without a meaning");
}

Truths AbstractEvaluator::compared(const Expr& e) const {
  const bool turned = e.op == Op::Greater || e.op == Op::GreaterEqual;
  const Interval& a = operand(e, turned ? 1 : 0).number;
  const Interval& b = operand(e, turned ? 0 : 1).number;
  const bool unknown = maybeUnknown(e.operands[0]) || maybeUnknown(e.operands[1]);
  if (a.empty || b.empty) {
    return {false, false, true};
  }
  const bool strict = e.op == Op::Less || e.op == Op::Greater;
  return strict ? Truths{a.lowest < b.highest, a.highest >= b.lowest, unknown}
                : Truths{a.lowest <= b.highest, a.highest > b.lowest, unknown};
}

}  // namespace glider::ir::prove
