// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/profile_modes.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/context/commands.h"

#include <algorithm>
#include <utility>

namespace glider::ir::prove {

ProfileModes::ProfileModes(const Mission& mission, const Activity& profile,
                           const GreatestFixpoint* known)
    : m_(mission), profile_(profile), known_(known) {
  const auto gather = [&](const Statement& statement) {
    const bool sets = statement.kind == StatementKind::Set &&
                      m_[statement.variable].type.kind == TypeKind::Bool &&
                      m_[statement.variable].kind == VariableKind::Profile;
    if (sets && std::ranges::find(own_, statement.variable) == own_.end()) {
      own_.push_back(statement.variable);
    }
  };
  forEachStatement(m_, profile.entry, gather);
  for (const Case& c : profile.cases) {
    forEachStatement(m_, c.action, gather);
  }
}

std::set<Mode> ProfileModes::begin() const {
  std::set<Mode> starts{{}};
  for (const VariableId id : own_) {
    std::set<Mode> after;
    for (Mode mode : starts) {
      const Truth initial = judge(m_[id].initial, mode);
      mode.truths.push_back(initial);
      after.merge(with(mode, mode.truths.size() - 1, initial));
    }
    starts = std::move(after);
  }
  return run(profile_.entry, std::move(starts));
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
std::set<Mode> ProfileModes::run(BlockId block, std::set<Mode> modes) const {
  if (!block.valid()) {
    return modes;
  }
  for (const Statement& statement : m_[block].statements) {
    std::set<Mode> after;
    for (const Mode& mode : modes) {
      after.merge(run(statement, mode));
    }
    modes = std::move(after);
  }
  return modes;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
std::set<Mode> ProfileModes::run(const Statement& statement, Mode mode) const {
  if (statement.kind == StatementKind::If) {
    const Truth condition = judge(statement.value, mode);
    std::set<Mode> after;
    if (condition == Truth::Unknown && maybeUnknown(statement.value)) {
      after.insert(mode);  // S2: neither branch runs
    }
    if (condition != Truth::False) {
      after.merge(run(statement.then, {mode}));
    }
    if (condition != Truth::True) {
      after.merge(run(statement.otherwise, {mode}));
    }
    return after;
  }
  const auto own = std::ranges::find(own_, statement.variable);
  if (statement.kind == StatementKind::Set && own != own_.end()) {
    return with(mode, static_cast<size_t>(own - own_.begin()), judge(statement.value, mode));
  }
  if (isVertical(statement)) {
    mode.command = statement.command;
  }
  return {mode};
}

bool ProfileModes::maybeUnknown(ExprId id) const {
  return known_ != nullptr && !known_->expressions[id.index];
}

/// Unknown represents either value.
std::set<Mode> ProfileModes::with(Mode mode, size_t number, Truth value) {
  if (value != Truth::Unknown) {
    mode.truths[number] = value;
    return {mode};
  }
  std::set<Mode> both;
  for (const Truth each : {Truth::False, Truth::True}) {
    mode.truths[number] = each;
    both.insert(mode);
  }
  return both;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
Truth ProfileModes::judge(ExprId id, const Mode& mode) const {
  const Expr& e = m_[id];
  const auto operand = [&](size_t i) { return judge(e.operands.at(i), mode); };
  if (groupOf(e.op) == OpGroup::Truth) {
    return truth(e.op != Op::False);
  }
  if (e.op == Op::Known) {
    return maybeUnknown(e.operands[0]) ? Truth::Unknown : Truth::True;
  }
  if (groupOf(e.op) == OpGroup::Logic) {
    return logical(opIn<LogicOp>(e.op), operand);
  }
  const auto own = e.op == Op::Variable ? std::ranges::find(own_, e.variable) : own_.end();
  const auto number = static_cast<size_t>(own - own_.begin());
  return number < mode.truths.size() ? mode.truths[number] : Truth::Unknown;
}

}  // namespace glider::ir::prove
