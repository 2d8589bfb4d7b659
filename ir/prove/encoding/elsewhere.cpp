// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The part of a mission that a question does not follow (scope.h): one place, in which each tick
// may leave anything in the mission's variables and the vehicle, and may enter any state that is
// followed. Only the monitor keeps what it has.

#include "ir/prove/encoding/chc_encoder.h"

#include <fmt/format.h>

namespace glider::ir::prove {

/// A climb that begins may be one that has been in force for longer.
void ChcEncoder::project(Rule& rule, Unknowns& unknowns) const {
  if (!watch_.scope || !rule.to) {
    return;
  }
  const Scope& scope = *watch_.scope;
  if (!scope.holds(rule.to->control)) {
    Control elsewhere = scope.elsewhere;
    elsewhere.just_returned = rule.to->control.just_returned;
    rule.to->control = elsewhere;
    rule.after->control = elsewhere;
  } else if (rule.after->store.vehicle && scope.climbs(rule.to->control) &&
             (!rule.from || !scope.climbs(rule.from->control))) {
    z3::expr& since = rule.after->store.vehicle->since;
    since = unknowns.real("climbing since");
    unknowns.require(since <= rule.after->mission_time);
    unknowns.require(knownDepth(*rule.after));
  }
  if (rule.after->store.vehicle && !scope.fine && rule.to->side == Side::Done) {
    rule.after->store.vehicle->depth = unknowns.real("depth");  // it does not matter any more
  }
  rule.to_row = layout_.row(*rule.after);
}

void ChcEncoder::leaveElsewhere(const Control& control) {
  const Control& elsewhere = watch_.scope->elsewhere;
  stepElsewhere(control, elsewhere, Way::Stays);
  stepElsewhere(control, elsewhere, Way::Ends);
  if (control.just_returned ? watch_.scope->returns_again : watch_.scope->returns) {
    Control resumed = elsewhere;
    resumed.just_returned = true;
    stepElsewhere(control, resumed, Way::Stays);
  }
  for (const Control& entered : watch_.scope->entered) {
    stepElsewhere(control, entered, Way::Enters);
  }
}

/// A tick, as it begins: what the monitor keeps is that of `before`, all else is unknown.
Configuration ChcEncoder::anywhere(const Control& control, const Configuration& before,
                                   Unknowns& unknowns) const {
  Configuration now = layout_.make(control, unknowns);
  now.mission_time = unknowns.real("now");
  if (watch_.scope->holds(control)) {  // it becomes current
    now.entered.back() = now.mission_time;
    now.resumed = now.mission_time;
  } else {
    now.entered.back() = unknowns.real("entered");
    now.resumed = unknowns.real("resumed");
    unknowns.require(now.entered.back() >= 0 && now.entered.back() <= now.resumed &&
                     now.resumed <= now.mission_time);
  }
  for (auto& [index, number] : now.store.numbers) {
    if (isOfMonitor(m_.variables[index].kind)) {
      number = before.store.numbers.at(index);
    }
  }
  for (auto& [index, truth] : now.store.truths) {
    if (isOfMonitor(m_.variables[index].kind)) {
      truth = before.store.truths.at(index);
    }
  }
  if (now.store.vehicle && watch_.scope->climbs(control)) {
    unknowns.require(now.store.vehicle->since <= now.mission_time);
  }
  return now;
}

z3::expr ChcEncoder::isNotLedAway(SymbolicState& moment) const {
  z3::expr stays = context_.bool_val(true);
  z3::expr none_before = context_.bool_val(true);
  for (const uint32_t number : watch_.scope->sure) {
    const Case& c = m_.always[number];
    const z3::expr fires = moment.truth(c.guard).is_true;
    if (c.target.valid() && watch_.scope->follows[c.target.index]) {
      stays = stays && !(none_before && fires);
    }
    none_before = none_before && !fires;
  }
  return stays;
}

z3::expr ChcEncoder::mayEnd(SymbolicState& moment) const {
  z3::expr ends = context_.bool_val(!watch_.scope->exits);
  for (const ExprId guard : watch_.scope->exits.value_or(std::vector<ExprId>())) {
    ends = ends || moment.truth(guard).is_true;
  }
  return ends;
}

void ChcEncoder::stepElsewhere(const Control& from, const Control& to, Way way) {
  Unknowns unknowns(context_, fmt::format("r{}:", next_prefix_++));
  const Configuration before = layout_.make(from, unknowns);
  Configuration now = anywhere(to, before, unknowns);
  SymbolicState moment = readingsOf(now, unknowns);
  z3::expr condition =
      now.mission_time >= before.mission_time &&
      now.mission_time - before.mission_time <= realOf(context_, proof_context_.tick_gap_s);
  now.store.show(moment);  // a parameter is the same in a guard and in the monitor
  const bool put_off = from.just_returned && watch_.scope->returns;
  if (way != Way::Enters && !put_off) {
    condition = condition && isNotLedAway(moment);
  }
  if (way == Way::Ends) {
    condition = condition && mayEnd(moment);
  }
  if (way == Way::Enters) {
    now = SymbolicTick(proof_context_, relevance_, unknowns).enter(std::move(now), moment);
  }
  Outcome outcome{context_.bool_val(true), std::nullopt, std::nullopt, ListKind::State, 0};
  if (way != Way::Ends) {
    outcome.after = now;
  }
  AfterMonitor left = leave(&outcome, std::move(now), moment);
  const Place place{from, Side::Done};
  addBad(place, layout_.row(before), condition, before, left, moment, unknowns);
  if (way != Way::Ends) {
    add({place,
         Place{to, Side::Done},
         layout_.row(before),
         layout_.row(left.configuration),
         condition,
         {},
         true,
         before,
         left.configuration,
         moment.readings()},
        unknowns);
  }
}

}  // namespace glider::ir::prove
