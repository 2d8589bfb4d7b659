// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/containment/replay.h"

#include "ir/core/ops.h"
#include "ir/eval/arithmetic.h"
#include "support/check.h"

#include <algorithm>

namespace glider::containment {

using namespace ir;

namespace {

void addOnce(std::vector<double>& values, double value) {
  const bool seen = std::ranges::any_of(
      values, [&](double v) { return v == value || (v != v && value != value); });
  if (!seen) {
    values.push_back(value);
  }
}

}  // namespace

Value Replay::value(ExprId root) const {
  return evaluate(m_, root, [&](const Expr& e, std::span<const double>) -> Value {
    const Interpreter& run = flight_->interpreter();
    const Tick& now = flight_->now();
    switch (groupOf(e.op)) {
      case OpGroup::Sensor:
        return run.readingOf(e.sensor);
      case OpGroup::Age:
        return now.ages[e.sensor.index];
      case OpGroup::Clock:
        return now.time - (e.op == Op::MissionTime ? 0
                           : e.op == Op::StateTime ? entered_
                                                   : resumed_);
      case OpGroup::Variable:
        return asValue(variables_[e.variable.index], e.type);
      case OpGroup::Temporal:
        return asValue(temporals_[e.temporal.index], e.type);
      case OpGroup::Call:  // the same for the whole tick
        return run.evaluate({static_cast<uint32_t>(&e - m_.exprs.data())});
      case OpGroup::Constant:
      case OpGroup::Truth:
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
    CHECK(false, "not a leaf");
  });
}

/// What every expression that has a meaning here has as its value now.
void Replay::record() {
  for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
    if (!reads_[i].two_states && (!reads_[i].state.valid() || reads_[i].state == state_)) {
      addOnce(values_[i], number({i}));
    }
  }
  for (uint32_t i = 0; i < temporals_.size(); ++i) {
    addOnce(windows_[i], temporals_[i]);
  }
}

void Replay::takeTemporals(const Flight& flight) {
  temporals_.assign(m_.temporals.size(), kUnknown);
  for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
    if (m_.exprs[i].op == Op::Temporal) {
      temporals_[m_.exprs[i].temporal.index] = asNumber(flight.interpreter().evaluate({i}));
    }
  }
}

void Replay::start(const Flight& flight) {
  flight_ = &flight;
  state_ = flight.now().result.state;
  entered_ = resumed_ = 0;
  variables_ = flight.now().result.variables;
  takeTemporals(flight);
  // The entries have run since, so that what began as true may have changed.
  watch(state_, true);
  watch(state_, false);
}

void Replay::watch(StateId state, bool always) {
  for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
    const Temporal& t = m_.temporals[i];
    if (!isWindow(t.kind) && (t.list == ListKind::Always) == always &&
        (always || t.state == state)) {
      watched_[i] = {number(t.operand) == 1, flight_->now().time};
    }
  }
}

void Replay::begun(const Flight& flight) {
  flight_ = &flight;
  values_.clear();
  windows_.clear();
  before_ = watched_;
  state_ = flight.before().result.state;
  entered_ = flight.now().entered;
  resumed_ = flight.now().resumed;
  variables_ = flight.before().result.variables;
  takeTemporals(flight);
  for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
    const Temporal& t = m_.temporals[i];
    if (!isWindow(t.kind) && (t.list == ListKind::Always || t.state == state_)) {
      const bool is = number(t.operand) == 1;
      const bool turned = t.kind == TemporalKind::Held && is && !watched_[i].was;
      watched_[i].since = turned ? flight.now().time : watched_[i].since;
      watched_[i].was = is;
    }
  }
  record();
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void Replay::execute(BlockId block) {
  if (!block.valid()) {
    return;
  }
  for (const Statement& s : m_[block].statements) {
    switch (s.kind) {
      case StatementKind::Set: {
        const double given = number(s.value);
        double& held = variables_[s.variable.index];
        held = isKnown(given) ? given : held;
        record();
        break;
      }
      case StatementKind::If: {
        const double condition = number(s.value);
        execute(condition == 1 ? s.then : condition == 0 ? s.otherwise : BlockId());
        break;
      }
      case StatementKind::Log:
      case StatementKind::Command:
        break;
    }
  }
}

void Replay::list(ListKind list, const std::vector<Case>& cases) {
  const TickResult& now = flight_->now().result;
  if (const auto fired = now.firedIn(list)) {
    const Case& c = cases[*fired];
    execute(c.action);
    if (now.moved && now.moved->list == list && !now.finished) {
      move(c);
    }
  }
}

void Replay::activity(ListKind list, const Activity& activity) {
  const auto fired = flight_->now().result.firedIn(list);
  if (!fired) {
    return;
  }
  const Case& c = activity.cases[*fired];
  execute(c.action);
  if (c.transition == Transition::Done && activity.done.valid()) {
    variables_[activity.done.index] = 1;
    record();
  }
}

void Replay::decided(const Flight& flight) {
  const State& state = m_[flight.before().result.state];
  const bool own_first = flight.before().result.just_returned;
  const bool moved = flight.now().result.moved.has_value();
  if (own_first) {
    list(ListKind::State, state.cases);
  }
  if (!own_first || !moved || flight.now().result.moved->list == ListKind::Always) {
    list(ListKind::Always, m_.always);
  }
  if (!own_first && (!moved || flight.now().result.moved->list == ListKind::State)) {
    list(ListKind::State, state.cases);
  }
  if (!moved) {
    activity(ListKind::Profile, state.profile);
    activity(ListKind::Route, state.route);
  }
}

void Replay::move(const Case& c) {
  std::vector<double> arguments;
  for (const ExprId id : c.arguments) {
    arguments.push_back(number(id));
  }
  state_ = flight_->now().result.state;
  entered_ = flight_->now().entered;
  resumed_ = flight_->now().resumed;
  const std::vector<double> before = temporals_;
  takeTemporals(*flight_);
  for (uint32_t i = 0; i < temporals_.size(); ++i) {
    temporals_[i] = m_.temporals[i].list == ListKind::Always ? before[i] : temporals_[i];
  }
  if (c.transition != Transition::Return) {
    for (size_t i = 0; i < arguments.size(); ++i) {
      variables_[m_[state_].parameters[i].index] = arguments[i];
    }
    record();
    enter();
    return;
  }
  record();
  watch(state_, false);
  execute(m_[state_].profile.entry);
  execute(m_[state_].route.entry);
}

void Replay::enter() {
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    const Variable& v = m_.variables[i];
    if (v.owner == state_ && v.kind != VariableKind::Argument) {
      variables_[i] = number(v.initial);
      record();
    }
  }
  watch(state_, false);
  execute(m_[state_].entry);
  execute(m_[state_].profile.entry);
  execute(m_[state_].route.entry);
}

std::vector<double> Replay::valuesOf(uint32_t expression) const {
  const auto found = values_.find(expression);
  return found == values_.end() ? std::vector<double>() : found->second;
}

std::vector<double> Replay::windowsOf(uint32_t temporal) const {
  const auto found = windows_.find(temporal);
  return found == windows_.end() ? std::vector<double>() : found->second;
}

}  // namespace glider::containment
