// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/chc_encoder.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"
#include "ir/prove/context/vehicle_rules.h"
#include "ir/prove/encoding/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {
namespace {

/// Call stacks; without calls there are no more than states (and what has just returned).
constexpr size_t kMostControls = 400;
constexpr size_t kMostStates = 1000;

bool calls(const std::vector<Case>& cases) {
  return std::ranges::find(cases, Transition::Call, &Case::transition) != cases.end();
}

/// The conjunction of all facts.
z3::expr allOf(const Unknowns& unknowns, z3::context& context) {
  z3::expr_vector facts(context);
  for (const Fact& fact : unknowns.facts()) {
    facts.push_back(fact.holds);
  }
  return z3::mk_and(facts);
}

}  // namespace

bool ChcEncoder::run() {
  const bool stacks = calls(m_.always) ||
                      std::ranges::any_of(m_.states, [](const State& s) { return calls(s.cases); });
  const size_t most = stacks ? kMostControls : kMostStates;
  begin();
  while (!pending_.empty() && reached_.size() <= most) {
    const Control control = pending_.back();
    pending_.pop_back();
    if (watch_.scope && !watch_.scope->holds(control)) {
      leaveElsewhere(control);
      continue;
    }
    elapse(control);
    tick(control);
    badAfter(control);
  }
  return pending_.empty();
}

void ChcEncoder::reach(const Control& control) {
  if (reached_.insert(control).second) {
    pending_.push_back(control);
  }
}

void ChcEncoder::add(Rule rule, Unknowns& unknowns) {
  project(rule, unknowns);
  rule.condition = (rule.condition && allOf(unknowns, context_)).simplify();
  if (rule.condition.is_false()) {
    return;
  }
  if (rule.to) {
    reach(rule.to->control);
  }
  rule.unknowns = unknowns.made();
  rules_.push_back(std::move(rule));
}

SymbolicState ChcEncoder::readingsOf(const Configuration& configuration, Unknowns& unknowns) const {
  SymbolicState moment(unknowns, proof_context_);
  moment.setClocks(configuration.mission_time, configuration.mission_time,
                   configuration.mission_time);
  for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
    const NumberTerm& reading = moment.reading({i});
    if (configuration.store.vehicle && proof_context_.depth == SensorId{i}) {  // V7
      const z3::expr error = moment.real(proof_context_.platform.world.depth_error_m);
      const z3::expr& depth = configuration.store.vehicle->depth;
      unknowns.require(z3::implies(
          reading.known, reading.value <= depth + error && reading.value >= depth - error));
    }
  }
  return moment;
}

/// Mission time 0: parameters within their ranges and conditions, the vehicle as it may be when
/// control is given.
void ChcEncoder::begin() {
  Unknowns unknowns(context_, fmt::format("r{}:", next_prefix_++));
  Control control;
  control.state = {0};
  const Layout whole(proof_context_, relevance_, watch_.memory);  // the vehicle with all of V1
  Configuration start = whole.make(control, unknowns);
  start.mission_time = context_.real_val(0);
  start.entered = {context_.real_val(0)};
  start.resumed = context_.real_val(0);
  SymbolicState moment = readingsOf(start, unknowns);
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    if (m_.variables[i].kind != VariableKind::Parameter || !relevance_.variables[i]) {
      continue;
    }
    if (m_.variables[i].type.kind == TypeKind::Bool) {
      start.store.truths.insert_or_assign(i, moment.truthOf(VariableId{i}));
    } else {
      start.store.numbers.insert_or_assign(i, moment.numberOf(VariableId{i}));
    }
  }
  z3::expr condition = context_.bool_val(true);
  for (const ExprId id : m_.conditions) {
    condition = condition && moment.truth(id).is_true;
  }
  for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
    if (m_.sensors[i].isHeard()) {  // nothing is received before the mission begins
      condition = condition && !moment.reading(SensorId{i}).known;
    }
  }
  if (start.store.vehicle) {
    condition = condition && begins(*start.store.vehicle, proof_context_.platform);
  }
  Configuration after =
      SymbolicTick(proof_context_, relevance_, unknowns).start(std::move(start), moment);
  if (watch_.begin) {
    watch_.begin(after);
  }
  AfterMonitor left = leave(nullptr, std::move(after), moment);
  addBad(std::nullopt, {}, condition, std::nullopt, left, moment, unknowns);
  after = std::move(left.configuration);
  Rule rule{std::nullopt, Place{control, Side::Done},
            {},           layout_.row(after),
            condition,    {},
            true,         std::nullopt,
            after,        moment.readings()};
  add(std::move(rule), unknowns);
}

void ChcEncoder::elapse(const Control& control) {
  Unknowns unknowns(context_, fmt::format("r{}:", next_prefix_++));
  const Configuration before = layout_.make(control, unknowns);
  Configuration after = before;
  after.mission_time = unknowns.real("now");
  // A frame that arrives late, after ticks of the SBC's own clock, does not advance the time.
  z3::expr condition = after.mission_time >= before.mission_time;
  if (before.store.vehicle) {
    after.store.vehicle->depth = unknowns.real("depth");
    if (isFine()) {
      condition = condition && moves(*before.store.vehicle, before.mission_time, after.mission_time,
                                     after.store.vehicle->depth, proof_context_.platform);
    } else {
      condition = condition && after.store.vehicle->depth >= 0;
    }
  }
  condition = condition && known(before) && knownDepth(after) && noticed(before, after, unknowns);
  if (watch_.every_tick) {
    condition = condition && after.mission_time - before.mission_time <=
                                 realOf(context_, proof_context_.tick_gap_s);
  }
  if (watch_.elapse) {
    watch_.elapse(before, after);
  }
  add({Place{control, Side::Done},
       Place{control, Side::Due},
       layout_.row(before),
       layout_.row(after),
       condition,
       {},
       false,
       before,
       after,
       {}},
      unknowns);
}

z3::expr ChcEncoder::known(const Configuration& now) const {
  z3::expr all = context_.bool_val(true);
  if (watch_.known.empty()) {
    return all;
  }
  const StateBounds& bounds = watch_.known[now.control.state.index];
  if (now.store.vehicle && std::isfinite(bounds.depth)) {
    all = all && now.store.vehicle->deepest <= realOf(context_, bounds.depth);
  }
  if (relevance_.resume_time && bounds.resume_time < kGreatestNumber) {
    all = all && now.mission_time - now.resumed <= realOf(context_, bounds.resume_time);
  }
  return all;
}

/// The time (s) after it became current from which the vehicle is at `depth` or above; none: its
/// commands do not say.
std::optional<double> ChcEncoder::climbIn(StateId state, double depth) const {
  const bool counted = watch_.scope || relevance_.resume_time;
  if (watch_.known.empty() || !watch_.known[state.index].climbs || !counted) {
    return std::nullopt;
  }
  return longestClimb(proof_context_.platform.world, watch_.known[state.index].depth, depth);
}

z3::expr ChcEncoder::hasClimbed(const Configuration& now, double depth, const z3::expr& by) const {
  if (!now.store.vehicle) {
    return context_.bool_val(false);
  }
  if (const auto climb = climbIn(now.control.state, depth)) {
    const z3::expr& since = watch_.scope ? now.store.vehicle->since : now.resumed;
    return by - since >= realOf(context_, *climb);
  }
  return hasClimbedTo(*now.store.vehicle, by, realOf(context_, depth), proof_context_.platform);
}

z3::expr ChcEncoder::knownDepth(const Configuration& now) const {
  z3::expr all = context_.bool_val(true);
  for (const double depth : watch_.awaited_depths) {
    if (now.store.vehicle && climbIn(now.control.state, depth)) {
      all = all && z3::implies(hasClimbed(now, depth, now.mission_time),
                               now.store.vehicle->depth <= realOf(context_, depth));
    }
  }
  return all;
}

/// The conditions of the control's lists that read only clocks and variables.
std::vector<ExprId> ChcEncoder::clockConditions(const Control& control) const {
  std::vector<ExprId> open;
  auto guards = [&](const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      open.push_back(c.guard);
    }
  };
  guards(m_.always);
  const State& state = m_[control.state];
  guards(state.cases);
  if (relevance_.profiles[control.state.index]) {
    guards(state.profile.cases);
  }
  if (relevance_.routes[control.state.index]) {
    guards(state.route.cases);
  }
  std::vector<ExprId> found;
  std::set<uint32_t> seen;
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!id.valid() || !seen.insert(id.index).second) {
      continue;
    }
    const Expr& e = m_[id];
    if (isComparison(e.op)) {
      if (readsNoSensor(id)) {
        found.push_back(id);
      }
      continue;
    }
    if (e.type.kind == TypeKind::Bool) {
      open.insert(open.end(), e.operands.begin(), e.operands.end());
    }
  }
  return found;
}

bool ChcEncoder::readsNoSensor(ExprId root) const {
  return !anyIn(m_, root, [](const Expr& e) {
    return e.op == Op::Sensor || e.op == Op::Age || e.op == Op::Temporal || e.op == Op::Call;
  });
}

/// Guards that fire for any readings of the sensors.
std::vector<ExprId> ChcEncoder::clockGuards(const Control& control) const {
  std::vector<ExprId> found;
  for (const auto* cases : {&m_.always, &m_[control.state].cases}) {
    for (const Case& c : *cases) {
      if (readsNoSensor(c.guard)) {
        found.push_back(c.guard);
      }
    }
  }
  return found;
}

/// If a condition became true longer ago than the gap, there has been a tick since: time stops
/// there first. A guard that was true then has fired.
z3::expr ChcEncoder::noticed(const Configuration& before, const Configuration& after,
                             Unknowns& unknowns) {
  const z3::expr gap = realOf(context_, proof_context_.tick_gap_s);
  const z3::expr late = after.mission_time - gap;
  auto at = [&](const z3::expr& time) {
    SymbolicState moment(unknowns, proof_context_);
    moment.setClocks(time, time - before.entered.back(), time - before.resumed);
    before.store.show(moment);
    return moment;
  };
  z3::expr same = context_.bool_val(true);
  if (isFine()) {
    SymbolicState then = at(before.mission_time);
    SymbolicState later = at(late);
    for (const ExprId id : clockConditions(before.control)) {
      same = same && then.truth(id).is_true == later.truth(id).is_true;
    }
    for (const ExprId guard : clockGuards(before.control)) {
      same = same && !later.truth(guard).is_true;
    }
  }
  for (const double depth : watch_.awaited_depths) {
    same = same &&
           (hasClimbed(before, depth, before.mission_time) || !hasClimbed(before, depth, late));
  }
  return late <= before.mission_time || same;
}

ChcEncoder::AfterMonitor ChcEncoder::leave(const Outcome* outcome, Configuration left,
                                           const SymbolicState& readings) const {
  SymbolicState seen = readings;
  left.store.show(seen);
  seen.setClocks(left.mission_time, left.mission_time - left.entered.back(),
                 left.mission_time - left.resumed);
  if (watch_.observe) {
    watch_.observe(outcome, left, seen);
  }
  return {std::move(left), std::move(seen)};
}

/// The state that a tick leaves may be bad: it is checked with the tick's readings.
void ChcEncoder::addBad(const std::optional<Place>& from, const std::vector<z3::expr>& row,
                        const z3::expr& condition, const std::optional<Configuration>& before,
                        AfterMonitor& left, const SymbolicState& readings, Unknowns& unknowns) {
  if (!watch_.bad_at_tick) {
    return;
  }
  if (const auto bad = watch_.bad_at_tick(left.configuration, left.moment)) {
    add({from,
         std::nullopt,
         row,
         {},
         condition && *bad,
         {},
         true,
         before,
         left.configuration,
         readings.readings()},
        unknowns);
  }
}

void ChcEncoder::tick(const Control& control) {
  Unknowns unknowns(context_, fmt::format("r{}:", next_prefix_++));
  const Configuration before = layout_.make(control, unknowns);
  // The tick comes after the time that has passed: its time is that of the configuration.
  const SymbolicState moment = readingsOf(before, unknowns);
  const auto outcomes = SymbolicTick(proof_context_, relevance_, unknowns)
                            .run(before, before.mission_time, moment, Pace::Many);
  const Place from{control, Side::Due};
  const std::vector<z3::expr> row = layout_.row(before);
  for (const Outcome& outcome : outcomes) {
    AfterMonitor left = leave(&outcome, outcome.after ? *outcome.after : *outcome.left, moment);
    addBad(from, row, outcome.condition, before, left, moment, unknowns);
    if (watch_.bad_move) {
      if (const auto bad = watch_.bad_move(before, outcome)) {
        add({from,
             std::nullopt,
             row,
             {},
             outcome.condition && *bad,
             {},
             true,
             before,
             outcome.after,
             moment.readings()},
            unknowns);
      }
    }
    if (!outcome.after) {
      continue;
    }
    Configuration after = std::move(left.configuration);
    if (watch_.move) {
      watch_.move(before, outcome, after);
    }
    add({from,
         Place{after.control, Side::Done},
         row,
         layout_.row(after),
         outcome.condition,
         {},
         true,
         before,
         after,
         moment.readings()},
        unknowns);
  }
}

void ChcEncoder::badAfter(const Control& control) {
  if (!watch_.bad_after) {
    return;
  }
  Unknowns unknowns(context_, fmt::format("r{}:", next_prefix_++));
  const Configuration now = layout_.make(control, unknowns);
  if (const auto bad = watch_.bad_after(now)) {
    add({Place{control, Side::Done},
         std::nullopt,
         layout_.row(now),
         {},
         *bad,
         {},
         false,
         now,
         std::nullopt,
         {}},
        unknowns);
  }
}

}  // namespace glider::ir::prove
