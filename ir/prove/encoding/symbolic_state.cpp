// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/symbolic_state.h"

#include "ir/core/ops.h"
#include "ir/verify/intervals.h"

#include <fmt/format.h>

#include <utility>

namespace glider::ir::prove {
namespace {

bool watchesState(const Temporal& temporal) {
  return temporal.list != ListKind::Always;
}

}  // namespace

void SymbolicState::bound(const NumberTerm& term, const Interval& interval, Fact::From from,
                          uint32_t index) {
  if (interval.empty) {
    unknowns_.require(!term.known, from, index);
    return;
  }
  if (interval.lowest > -kGreatestNumber) {
    unknowns_.require(z3::implies(term.known, term.value >= real(interval.lowest)), from, index);
  }
  if (interval.highest < kGreatestNumber) {
    unknowns_.require(z3::implies(term.known, term.value <= real(interval.highest)), from, index);
  }
}

const NumberTerm& SymbolicState::reading(SensorId id) {
  const auto found = readings_.find(id.index);
  if (found != readings_.end()) {
    return found->second;
  }
  const Sensor& sensor = mission_[id];
  const NumberTerm term{unknowns_.real(sensor.name), unknowns_.truth(sensor.name + "?"), 0};
  bound(term, proof_context_.sensors[id.index], Fact::From::Sensor, id.index);
  return readings_.emplace(id.index, term).first->second;
}

/// A reading that is known is not stale.
const z3::expr& SymbolicState::age(SensorId id) {
  const auto found = ages_.find(id.index);
  if (found != ages_.end()) {
    return found->second;
  }
  const z3::expr value = unknowns_.real("age of " + mission_[id].name);
  unknowns_.require(value >= 0 && value <= missionTime());
  unknowns_.require(z3::implies(reading(id).known, value <= real(mission_[id].stale_after_s)),
                    Fact::From::Age, id.index);
  return ages_.emplace(id.index, value).first->second;
}

const z3::expr& SymbolicState::missionTime() {
  if (!mission_time_) {
    mission_time_ = unknowns_.real("missiontime");
    unknowns_.require(*mission_time_ >= 0);
  }
  return *mission_time_;
}

const z3::expr& SymbolicState::stateTime() {
  if (!state_time_) {
    state_time_ = unknowns_.real("statetime");
    unknowns_.require(*state_time_ >= 0 && *state_time_ <= missionTime());
  }
  return *state_time_;
}

const z3::expr& SymbolicState::resumeTime() {
  if (!is_resumed_) {
    return stateTime();
  }
  if (!resume_time_) {
    resume_time_ = unknowns_.real("resumetime");
    unknowns_.require(*resume_time_ >= 0 && *resume_time_ <= stateTime());
  }
  return *resume_time_;
}

void SymbolicState::setClocks(z3::expr mission_time, z3::expr state_time, z3::expr resume_time) {
  mission_time_ = std::move(mission_time);
  state_time_ = std::move(state_time);
  resume_time_ = std::move(resume_time);
}

std::vector<std::pair<const char*, z3::expr>> SymbolicState::clocks() const {
  std::vector<std::pair<const char*, z3::expr>> all;
  const std::pair<const char*, const std::optional<z3::expr>*> clocks[] = {
      {"missiontime", &mission_time_}, {"statetime", &state_time_}, {"resumetime", &resume_time_}};
  for (const auto& [name, clock] : clocks) {
    if (*clock) {
      all.emplace_back(name, **clock);
    }
  }
  return all;
}

z3::expr SymbolicState::knownOf(VariableId id) {
  return proof_context_.known.variables[id.index] ? context().bool_val(true)
                                                  : unknowns_.truth(mission_[id].name + "?");
}

const NumberTerm& SymbolicState::numberOf(VariableId id) {
  const auto found = numbers_.find(id.index);
  if (found != numbers_.end()) {
    return found->second;
  }
  const Variable& variable = mission_[id];
  const NumberTerm term{unknowns_.real(variable.name), knownOf(id), 0};
  bound(term, {variable.lowest, variable.highest, false}, Fact::From::Variable, id.index);
  return numbers_.emplace(id.index, term).first->second;
}

const TruthTerm& SymbolicState::truthOf(VariableId id) {
  const auto found = truths_.find(id.index);
  if (found != truths_.end()) {
    return found->second;
  }
  const z3::expr value = unknowns_.truth(mission_[id].name);
  const z3::expr known = knownOf(id);
  return truths_.emplace(id.index, TruthTerm{value && known, !value && known}).first->second;
}

/// A window is known only once its time has passed since its state was entered.
const NumberTerm& SymbolicState::numberOf(TemporalId id) {
  const auto found = watched_numbers_.find(id.index);
  if (found != watched_numbers_.end()) {
    return found->second;
  }
  const Temporal& temporal = mission_[id];
  const NumberTerm term{unknowns_.real("window", id.index), unknowns_.truth("window?", id.index),
                        0};
  bound(term, proof_context_.windows[id.index], Fact::From::Temporal, id.index);
  if (!temporal.along.valid()) {
    const z3::expr& since = watchesState(temporal) ? stateTime() : missionTime();
    unknowns_.require(z3::implies(term.known, since >= real(temporal.length)), Fact::From::Temporal,
                      id.index);
  }
  return watched_numbers_.emplace(id.index, term).first->second;
}

/// The values that the temporal reads are computed in this state first, so that both states share
/// them; what a list has set since may then be anything.
SymbolicState SymbolicState::whenJudged(TemporalId id) {
  SymbolicState then = *this;
  for (const VariableId variable : proof_context_.set_since[id.index]) {
    then.numbers_.erase(variable.index);
    then.truths_.erase(variable.index);
  }
  then.forget();
  return then;
}

/// `became` and `held` are true only while what they watch was true as the tick began; `held` has
/// watched it for its time since its list became current.
const TruthTerm& SymbolicState::truthOf(TemporalId id) {
  const auto found = watched_truths_.find(id.index);
  if (found != watched_truths_.end()) {
    return found->second;
  }
  const Temporal& temporal = mission_[id];
  (void)truth(temporal.operand);
  if (temporal.kind == TemporalKind::Held) {
    (void)number(temporal.duration);
  }
  std::optional<SymbolicState> before;
  SymbolicState& then =
      proof_context_.set_since[id.index].empty() ? *this : before.emplace(whenJudged(id));
  const TruthTerm watched = then.truth(temporal.operand);
  z3::expr is_true = unknowns_.truth("watched") && watched.is_true;
  z3::expr known = watched.is_true || watched.is_false;
  if (temporal.kind == TemporalKind::Held) {
    const NumberTerm duration = then.number(temporal.duration);
    const z3::expr& since = watchesState(temporal) ? resumeTime() : missionTime();
    is_true = is_true && duration.known && since >= duration.value - real(duration.slack);
    known = watched.is_false || (watched.is_true && duration.known);
  }
  return watched_truths_.emplace(id.index, TruthTerm{is_true, known && !is_true}).first->second;
}

const NumberTerm& SymbolicState::numberOf(UseId id) {
  const auto found = called_numbers_.find(id.index);
  if (found != called_numbers_.end()) {
    return found->second;
  }
  const Function& function = mission_[id];
  const NumberTerm term{unknowns_.real(function.name), unknowns_.truth(function.name + "?"), 0};
  bound(term, {function.lowest, function.highest, false});
  return called_numbers_.emplace(id.index, term).first->second;
}

const TruthTerm& SymbolicState::truthOf(UseId id) {
  const auto found = called_truths_.find(id.index);
  if (found != called_truths_.end()) {
    return found->second;
  }
  const z3::expr value = unknowns_.truth(mission_[id].name);
  const z3::expr known = unknowns_.truth(mission_[id].name + "?");
  return called_truths_.emplace(id.index, TruthTerm{value && known, !value && known}).first->second;
}

void SymbolicState::restart(StateId state) {
  const auto starts = [&](const auto& entry) {
    const Temporal& temporal = mission_.temporals[entry.first];
    return watchesState(temporal) && temporal.state == state;
  };
  std::erase_if(watched_numbers_, starts);
  std::erase_if(watched_truths_, starts);
  forget();
}

void SymbolicState::forget() {
  made_.clear();
  made_truths_.clear();
}

const NumberTerm& SymbolicState::number(ExprId id) {
  lower(id);
  return made_.at(id.index);
}

const TruthTerm& SymbolicState::truth(ExprId id) {
  lower(id);
  return made_truths_.at(id.index);
}

/// Without recursion over operands, at any depth: they have smaller ids.
void SymbolicState::lower(ExprId root) {
  auto done = [&](uint32_t index) { return made_.contains(index) || made_truths_.contains(index); };
  std::vector<uint32_t> open{root.index};
  while (!open.empty()) {
    const uint32_t index = open.back();
    const Expr& e = mission_.exprs[index];
    bool ready = true;
    for (uint32_t k = 0; k < opInfo(e.op).operands; ++k) {
      if (const uint32_t operand = e.operands.at(k).index; !done(operand)) {
        open.push_back(operand);
        ready = false;
      }
    }
    if (ready) {
      open.pop_back();
      if (!done(index)) {
        lowerOne(index);
      }
    }
  }
}

void SymbolicState::lowerOne(uint32_t index) {
  if (mission_.exprs[index].type.kind == TypeKind::Bool) {
    lowerTruth(index);
  } else {
    lowerNumber(index);
  }
}

}  // namespace glider::ir::prove
