// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/abstract_run.h"

#include "ir/core/walk.h"

namespace glider::ir::prove {

Valuation AbstractRun::begin() const {
  Valuation values;
  for (const Variable& variable : m_.variables) {
    values.push_back(anything(variable));
  }
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    if (m_.variables[i].kind == VariableKind::Parameter) {
      values[i].truths.is_unknown = false;
    } else if (m_.variables[i].kind == VariableKind::Mission) {
      start(i, {}, values);
    }
  }
  return values;
}

void AbstractRun::start(uint32_t variable, const ClockRanges& clocks, Valuation& values) const {
  const ExprId initial = m_.variables[variable].initial;
  const AbstractEvaluator now(proof_context_, values, clocks);
  const PossibleValues begins = now.holding(initial);
  work_ += now.work();
  values[variable] = begins;
}

/// An unknown value changes nothing. No value leaves the variable's range: `ir/verify` has proved
/// that.
void AbstractRun::set(const Statement& statement, const ClockRanges& clocks,
                      Valuation& values) const {
  const AbstractEvaluator now(proof_context_, values, clocks);
  PossibleValues given = withinRange(now.holding(statement.value), m_[statement.variable]);
  work_ += now.work();
  const bool stays = now.maybeUnknown(statement.value);
  given.truths.is_unknown = false;
  PossibleValues& held = values[statement.variable.index];
  held = stays ? either(held, given) : given;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void AbstractRun::execute(BlockId block, const ClockRanges& clocks, Valuation& values) const {
  if (!block.valid()) {
    return;
  }
  for (const Statement& statement : m_[block].statements) {
    if (statement.kind == StatementKind::Set) {
      set(statement, clocks, values);
    } else if (statement.kind == StatementKind::If) {
      branch(statement, clocks, values);
    }
  }
}

/// An unknown condition takes neither branch.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void AbstractRun::branch(const Statement& statement, const ClockRanges& clocks,
                         Valuation& values) const {
  const bool maybe_neither = !proof_context_.known.expressions[statement.value.index];
  const Valuation before = values;
  Valuation otherwise = values;
  execute(statement.then, clocks, values);
  execute(statement.otherwise, clocks, otherwise);
  for (size_t i = 0; i < values.size(); ++i) {
    values[i] = either(values[i], otherwise[i]);
    values[i] = maybe_neither ? either(values[i], before[i]) : values[i];
  }
}

void AbstractRun::forget(BlockId block, Valuation& values) const {
  forEachStatement(m_, block, [&](const Statement& statement) {
    if (statement.kind == StatementKind::Set) {
      values[statement.variable.index] = anything(m_[statement.variable]);
    }
  });
}

void AbstractRun::enter(StateId state, const Case* c, const ClockRanges& clocks,
                        Valuation& values) const {
  if (c != nullptr) {
    std::vector<PossibleValues> passed;  // all before any changes: `goto b(y, x)` swaps
    const AbstractEvaluator now(proof_context_, values, clocks);
    for (const ExprId argument : c->arguments) {
      passed.push_back(now.holding(argument));
    }
    work_ += now.work();
    for (size_t i = 0; i < passed.size(); ++i) {
      values[m_[state].parameters[i].index] = passed[i];
    }
  }
  constexpr Interval kNow{0, 0, false};
  const ClockRanges entering{clocks.mission_time, kNow, kNow};
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    const Variable& variable = m_.variables[i];
    const bool starts = variable.owner == state && variable.kind != VariableKind::Argument;
    if (starts) {
      start(i, entering, values);
    }
  }
  execute(m_[state].entry, entering, values);
  execute(m_[state].profile.entry, entering, values);
  execute(m_[state].route.entry, entering, values);
}

void AbstractRun::resume(StateId state, const ClockRanges& clocks, Valuation& values) const {
  execute(m_[state].profile.entry, clocks, values);
  execute(m_[state].route.entry, clocks, values);
}

}  // namespace glider::ir::prove
