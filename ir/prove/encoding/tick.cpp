// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/tick.h"

#include "ir/prove/encoding/world.h"

#include <utility>

namespace glider::ir::prove {

/// A tick in progress.
struct SymbolicTick::Run {
  const Configuration& before;
  z3::expr now;
  SymbolicState moment;
  Store store;
  std::map<uint32_t, Watched> watched;
  z3::expr alive;  ///< no transition yet
  std::vector<Outcome> outcomes;
};

std::vector<Outcome> SymbolicTick::run(const Configuration& before, const z3::expr& now,
                                       const SymbolicState& readings, Pace pace) {
  z3::context& context = unknowns_.context();
  Run run{before, now, readings, before.store, before.watched, context.bool_val(true), {}};
  run.moment.setClocks(now, now - before.entered.back(), now - before.resumed);
  run.store.show(run.moment);
  advance(run, pace);
  const State& state = m_[before.control.state];
  const bool own_first = before.control.just_returned;
  tryList(run, own_first ? ListKind::State : ListKind::Always, own_first ? state.cases : m_.always);
  tryList(run, own_first ? ListKind::Always : ListKind::State, own_first ? m_.always : state.cases);
  runActivity(run, state.profile, relevance_.profiles[before.control.state.index]);
  runActivity(run, state.route, relevance_.routes[before.control.state.index]);
  Configuration stays = before;
  stays.control.just_returned = false;
  stays.mission_time = now;
  stays.store = run.store;
  stays.watched = run.watched;
  run.outcomes.push_back(
      {run.alive, std::move(stays), std::nullopt, ListKind::State, std::nullopt});
  return std::move(run.outcomes);
}

void SymbolicTick::advance(Run& run, Pace pace) {
  for (const auto& [index, kept] : run.before.watched) {
    advanceOne(run, {index}, pace);
  }
}

/// If many ticks have passed since the last, the operand may have turned false and true again.
void SymbolicTick::advanceOne(Run& run, TemporalId id, Pace pace) {
  const Temporal& temporal = m_[id];
  const Watched& kept = run.before.watched.at(id.index);
  const TruthTerm operand = run.moment.truth(temporal.operand);
  const z3::expr known = operand.is_true || operand.is_false;
  const bool many = pace == Pace::Many;
  if (temporal.kind == TemporalKind::Became) {
    const z3::expr before = many ? unknowns_.truth("was true", id.index) : kept.was_true;
    const z3::expr turned = operand.is_true && !before;
    run.moment.set(id, TruthTerm{turned, known && !turned});
    run.watched.insert_or_assign(id.index, Watched{operand.is_true, kept.since});
    return;
  }
  z3::expr since = z3::ite(operand.is_true && !kept.was_true, run.now, kept.since);
  if (many) {
    since = unknowns_.real("since", id.index);
    unknowns_.require(since >= kept.since && since <= run.now);
  }
  run.moment.set(id, heldFor(run.moment, temporal, operand, run.now - since));
  run.watched.insert_or_assign(id.index, Watched{operand.is_true, since});
}

/// Guards are evaluated before any action of the list: the first that is true fires.
bool SymbolicTick::tryList(Run& run, ListKind list, const std::vector<Case>& cases) {
  z3::context& context = unknowns_.context();
  z3::expr none_yet = context.bool_val(true);
  std::vector<std::pair<uint32_t, z3::expr>> fires;
  for (uint32_t i = 0; i < cases.size(); ++i) {
    if (list == ListKind::Always && !run.before.control.mayInterrupt(m_, i)) {
      continue;
    }
    const z3::expr is_true = run.moment.truth(cases[i].guard).is_true;
    fires.emplace_back(i, none_yet && is_true);
    none_yet = none_yet && !is_true;
  }
  const Store before = run.store;
  z3::expr goes_on = none_yet;
  for (const auto& [number, fired] : fires) {
    const Case& c = cases[number];
    Store after = execute(run.moment, c.action, before, run.now);
    if (c.transition == Transition::Stay) {
      run.store = choose(fired, after, run.store);
      goes_on = goes_on || fired;
    } else {
      fire(run, list, number, c, run.alive && fired, after);
    }
  }
  run.alive = run.alive && goes_on;
  run.store.show(run.moment);
  return !fires.empty();
}

void SymbolicTick::fire(Run& run, ListKind list, uint32_t number, const Case& c,
                        const z3::expr& condition, const Store& after_action) {
  if (c.transition == Transition::Return && run.before.control.stack.empty()) {
    return;  // its guard is never true: `verify` refuses every other mission (GL3005)
  }
  Outcome outcome{condition, std::nullopt, std::nullopt, list, number};
  Configuration after = run.before;
  after.mission_time = run.now;
  after.store = after_action;
  if (c.transition == Transition::Exit) {
    outcome.left = std::move(after);
  } else {
    after.resumed = run.now;
    after.watched = run.watched;
    after.control = run.before.control.moved(list, number, c);
    SymbolicState moment = run.moment;
    after.store.show(moment);
    if (c.transition == Transition::Return) {
      after.entered.pop_back();
      outcome.after = resume(std::move(after), std::move(moment));
    } else {
      if (c.transition == Transition::Goto) {
        after.entered.clear();
      }
      after.entered.push_back(run.now);
      pass(moment, c, after.store);
      outcome.after = enter(std::move(after), std::move(moment));
    }
  }
  run.outcomes.push_back(std::move(outcome));
}

/// The arguments are evaluated together, before any parameter changes: `goto b(y, x)` swaps.
void SymbolicTick::pass(const SymbolicState& before, const Case& c, Store& store) {
  const Store asked = store;
  for (size_t i = 0; i < c.arguments.size(); ++i) {
    SymbolicState moment = before;
    asked.show(moment);
    assign(moment, m_[c.target].parameters[i], c.arguments[i], store, true);
  }
}

void SymbolicTick::runActivity(Run& run, const Activity& activity, bool relevant) {
  if (!relevant) {
    return;
  }
  if (!m_[activity.behaviour].symbol.empty()) {
    if (run.store.vehicle) {  // a route in C may command depths too
      run.store.vehicle = obeyAnything(*run.store.vehicle, unknowns_);
    }
    return;
  }
  z3::expr none_yet = unknowns_.context().bool_val(true);
  const Store before = run.store;
  std::vector<std::pair<z3::expr, const Case*>> fires;
  for (const Case& c : activity.cases) {
    const z3::expr is_true = run.moment.truth(c.guard).is_true;
    fires.emplace_back(none_yet && is_true, &c);
    none_yet = none_yet && !is_true;
  }
  for (const auto& [fired, c] : fires) {
    Store after = execute(run.moment, c->action, before, run.now);
    if (c->transition == Transition::Done && after.truths.contains(activity.done.index)) {
      z3::context& context = unknowns_.context();
      after.truths.insert_or_assign(activity.done.index,
                                    TruthTerm{context.bool_val(true), context.bool_val(false)});
    }
    run.store = choose(fired, after, run.store);
  }
  run.store.show(run.moment);
}

}  // namespace glider::ir::prove
