// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/timer_guards.h"

#include "ir/core/walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kNotBounded = std::numeric_limits<double>::infinity();
constexpr Interval kAnyTime{0, kGreatestNumber, false};

/// Of each variable, whether all that is assigned to it, something at least, is `missiontime`.
std::vector<bool> variablesOfTimes(const Mission& mission) {
  std::vector<bool> times(mission.variables.size());
  std::vector<bool> others(mission.variables.size());
  for (const Block& block : mission.blocks) {
    for (const Statement& s : block.statements) {
      if (s.kind == StatementKind::Set) {
        const bool time = mission[s.value].op == Op::MissionTime;
        (time ? times : others)[s.variable.index] = true;
      }
    }
  }
  for (size_t i = 0; i < times.size(); ++i) {
    times[i] = times[i] && !others[i];
  }
  return times;
}

}  // namespace

TimerGuards::TimerGuards(const ProofContext& proof_context, const Valuation& values, double ends_by)
    : m_(proof_context.mission),
      ends_by_(ends_by),
      evaluator_(proof_context, values, {kAnyTime, kAnyTime, kAnyTime}),
      times_(variablesOfTimes(m_)) {}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
double TimerGuards::trueAfter(ExprId guard, VariableId since, const Certain& certain) const {
  if (certain(guard)) {
    return 0;
  }
  const Expr& e = m_[guard];
  if (e.op == Op::Or || e.op == Op::And) {
    const double a = trueAfter(e.operands[0], since, certain);
    const double b = trueAfter(e.operands[1], since, certain);
    return e.op == Op::Or ? std::min(a, b) : std::max(a, b);
  }
  return compared(e, since).most;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
double TimerGuards::onlyAfter(ExprId guard, VariableId since) const {
  const Expr& e = m_[guard];
  if (e.op == Op::Or || e.op == Op::And) {
    const double a = onlyAfter(e.operands[0], since);
    const double b = onlyAfter(e.operands[1], since);
    return e.op == Op::Or ? std::min(a, b) : std::max(a, b);
  }
  return compared(e, since).least;
}

TimerGuards::Apart TimerGuards::compared(const Expr& e, VariableId since) const {
  if (e.op == Op::Greater || e.op == Op::GreaterEqual) {
    return apart(e.operands[0], e.operands[1], since);
  }
  if (e.op == Op::Less || e.op == Op::LessEqual) {
    return apart(e.operands[1], e.operands[0], since);
  }
  return {0, kNotBounded};
}

TimerGuards::Apart TimerGuards::apart(ExprId more, ExprId less, VariableId since) const {
  const Expr& a = m_[more];
  const Expr& b = m_[less];
  if (a.op == Op::Subtract && m_[a.operands[0]].op == Op::MissionTime &&
      isSince(a.operands[1], since)) {
    return boundsOf(less);
  }
  if (a.op != Op::MissionTime || b.op != Op::Add) {
    return {0, kNotBounded};
  }
  const bool first = isSince(b.operands[0], since);
  if (!first && !isSince(b.operands[1], since)) {
    return {0, kNotBounded};
  }
  // The sum, about the mission time, was rounded; the later, the more.
  const Apart bounds = boundsOf(b.operands[first ? 1 : 0]);
  const double rounded = (bounds.most + ends_by_) * 0x1p-50;
  return {std::max(bounds.least - rounded, 0.0), bounds.most + rounded};
}

bool TimerGuards::isSince(ExprId id, VariableId since) const {
  return m_[id].op == Op::Variable && m_[id].variable == since;
}

/// Of an expression that may be unknown only the least counts. Widened by what rounding adds.
TimerGuards::Apart TimerGuards::boundsOf(ExprId id) const {
  constexpr double kRounding = 0x1p-40;
  constexpr double kSettled = 1e-6;
  const Interval& value = evaluator_.number(id);
  const double least = std::max(value.lowest * (1 - kRounding) - kSettled, 0.0);
  const double most = std::max(value.highest, 0.0);
  const bool bounded = !evaluator_.maybeUnknown(id) && most < kGreatestNumber;
  return {value.empty ? 0 : least, bounded ? most * (1 + kRounding) + kSettled : kNotBounded};
}

bool sets(const Mission& mission, BlockId block, VariableId variable) {
  bool found = false;
  forEachStatement(mission, block, [&](const Statement& s) {
    found = found || (s.kind == StatementKind::Set && s.variable == variable);
  });
  return found;
}

}  // namespace glider::ir::prove
