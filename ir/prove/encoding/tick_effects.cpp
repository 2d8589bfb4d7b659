// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a tick does: statements, and entering or resuming a state.

#include "ir/core/ops.h"
#include "ir/prove/encoding/tick.h"
#include "ir/prove/encoding/world.h"
#include "ir/verify/intervals.h"

#include <utility>

namespace glider::ir::prove {

Store SymbolicTick::execute(SymbolicState& moment, BlockId block, Store store,
                            const z3::expr& now) {
  store.show(moment);
  if (block.valid()) {
    for (const Statement& statement : m_[block].statements) {
      store = executeOne(moment, statement, std::move(store), now);
    }
  }
  return store;
}

Store SymbolicTick::executeOne(SymbolicState& moment, const Statement& statement, Store store,
                               const z3::expr& now) {
  switch (statement.kind) {
    case StatementKind::Set:
      assign(moment, statement.variable, statement.value, store, false);
      break;
    case StatementKind::If: {
      const TruthTerm condition = moment.truth(statement.value);
      const Store yes = execute(moment, statement.then, store, now);
      const Store no = execute(moment, statement.otherwise, store, now);
      store = choose(condition.is_true, yes, choose(condition.is_false, no, store));
      store.show(moment);
      break;
    }
    case StatementKind::Command: {
      if (!store.vehicle) {
        break;
      }
      std::vector<NumberTerm> arguments;
      z3::expr allowed = moment.context().bool_val(true);
      for (const ExprId argument : statement.values) {
        arguments.push_back(rounded(moment, argument));
        allowed = allowed && arguments.back().known;
      }
      store.vehicle = obey(*store.vehicle, statement.command, arguments, now, allowed,
                           proof_context_.platform, unknowns_);
      break;
    }
    case StatementKind::Log:
      break;
  }
  return store;
}

void SymbolicTick::bound(SymbolicState& moment, const NumberTerm& term, const Interval& interval) {
  if (interval.lowest > -kGreatestNumber) {
    unknowns_.require(z3::implies(term.known, term.value >= moment.real(interval.lowest)));
  }
  if (interval.highest < kGreatestNumber) {
    unknowns_.require(z3::implies(term.known, term.value <= moment.real(interval.highest)));
  }
}

/// The double that the machine gets: a rounding error becomes an unknown of its own.
NumberTerm SymbolicTick::rounded(SymbolicState& moment, ExprId value) {
  const NumberTerm given = moment.number(value);
  if (given.slack == 0) {
    return given;
  }
  const z3::expr rounded = unknowns_.real("rounded", value.index);
  const z3::expr slack = moment.real(given.slack);
  const z3::expr near = rounded - given.value <= slack && given.value - rounded <= slack;
  unknowns_.require(z3::implies(given.known, near));
  NumberTerm term{rounded, given.known, 0};
  bound(moment, term, proof_context_.intervals[value.index]);
  return term;
}

/// A variable's term has no slack. A variable may be unknown when it starts; `set` leaves it
/// unchanged where the value is unknown.
void SymbolicTick::assign(SymbolicState& moment, VariableId variable, ExprId value, Store& store,
                          bool start) {
  if (!relevance_.variables[variable.index]) {
    return;
  }
  if (m_[variable].type.kind == TypeKind::Bool) {
    TruthTerm& held = store.truths.at(variable.index);
    const TruthTerm given = moment.truth(value);
    const z3::expr known = given.is_true || given.is_false;
    held = start ? given
                 : TruthTerm{given.is_true || (!known && held.is_true),
                             given.is_false || (!known && held.is_false)};
    moment.set(variable, held);
  } else {
    NumberTerm& held = store.numbers.at(variable.index);
    const NumberTerm given = rounded(moment, value);
    held = start ? given
                 : NumberTerm{z3::ite(given.known, given.value, held.value),
                              given.known || held.known, 0};
    moment.set(variable, held);
  }
  moment.forget();
}

/// The value of `held` when its operand has been true for so long, s. A duration that is not
/// constant may be 0, negative or unknown; within its rounding error the machine may give either
/// answer.
TruthTerm SymbolicTick::heldFor(SymbolicState& moment, const Temporal& temporal,
                                const TruthTerm& operand, const z3::expr& since) {
  const NumberTerm duration = moment.number(temporal.duration);
  z3::expr long_enough = since >= duration.value;
  if (duration.slack > 0) {
    const z3::expr slack = moment.real(duration.slack);
    const z3::expr apart = since - duration.value > slack || duration.value - since > slack;
    long_enough = z3::ite(apart, long_enough, unknowns_.truth("rounding"));
  }
  const z3::expr compared = operand.is_true && duration.known;
  return {compared && long_enough, operand.is_false || (compared && !long_enough)};
}

/// `became` and `held` of a list start from the current values of their operands.
void SymbolicTick::startWatching(SymbolicState& moment, ListKind list, StateId state,
                                 Configuration& configuration) {
  z3::context& context = unknowns_.context();
  for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
    const Temporal& temporal = m_.temporals[i];
    const bool here =
        list == ListKind::Always ? temporal.list == ListKind::Always : temporal.state == state;
    if (!here || isWindow(temporal.kind) || !relevance_.temporals[i]) {
      continue;
    }
    const TruthTerm operand = moment.truth(temporal.operand);
    configuration.watched.insert_or_assign(i, Watched{operand.is_true, configuration.mission_time});
    const TruthTerm starts =
        temporal.kind == TemporalKind::Held
            ? heldFor(moment, temporal, operand, context.real_val(0))
            : TruthTerm{context.bool_val(false), operand.is_true || operand.is_false};
    moment.set(TemporalId{i}, starts);
  }
}

namespace {

/// Forgets what the state that was left watched: that starts again when the state is entered or
/// resumed.
void keepWatchOfAlways(const Mission& mission, Configuration& configuration) {
  std::erase_if(configuration.watched, [&](const auto& entry) {
    return mission.temporals[entry.first].list != ListKind::Always;
  });
}

}  // namespace

Configuration SymbolicTick::enter(Configuration after, SymbolicState moment) {
  z3::context& context = unknowns_.context();
  const StateId id = after.control.state;
  const State& state = m_[id];
  moment.setClocks(after.mission_time, context.real_val(0), context.real_val(0));
  moment.restart(id);
  after.store.show(moment);
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    const Variable& variable = m_.variables[i];
    if (variable.owner == id && variable.kind != VariableKind::Argument) {
      assign(moment, {i}, variable.initial, after.store, true);
    }
  }
  keepWatchOfAlways(m_, after);
  startWatching(moment, ListKind::State, id, after);
  after.store = execute(moment, state.entry, std::move(after.store), after.mission_time);
  runEntry(moment, state.profile, relevance_.profiles[id.index], after);
  runEntry(moment, state.route, relevance_.routes[id.index], after);
  return after;
}

Configuration SymbolicTick::resume(Configuration after, SymbolicState moment) {
  const StateId id = after.control.state;
  moment.setClocks(after.mission_time, after.mission_time - after.entered.back(),
                   unknowns_.context().real_val(0));
  moment.forget();
  keepWatchOfAlways(m_, after);
  startWatching(moment, ListKind::State, id, after);
  runEntry(moment, m_[id].profile, relevance_.profiles[id.index], after);
  runEntry(moment, m_[id].route, relevance_.routes[id.index], after);
  return after;
}

void SymbolicTick::runEntry(SymbolicState& moment, const Activity& activity, bool relevant,
                            Configuration& after) {
  if (!relevant) {
    return;
  }
  if (m_[activity.behaviour].symbol.empty()) {
    after.store = execute(moment, activity.entry, std::move(after.store), after.mission_time);
  } else if (after.store.vehicle) {
    after.store.vehicle = obeyAnything(*after.store.vehicle, unknowns_);
  }
}

Configuration SymbolicTick::start(Configuration before, const SymbolicState& readings) {
  SymbolicState moment = readings;
  moment.setClocks(before.mission_time, before.mission_time, before.mission_time);
  before.store.show(moment);
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    const VariableKind kind = m_.variables[i].kind;
    if (kind == VariableKind::Mission || kind == VariableKind::Monitor) {
      assign(moment, {i}, m_.variables[i].initial, before.store, true);
    }
  }
  startWatching(moment, ListKind::Always, {}, before);
  return enter(std::move(before), std::move(moment));
}

}  // namespace glider::ir::prove
