// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the interpreter keeps from tick to tick: `became`, `held` and windows.

#include "ir/core/ops.h"
#include "ir/eval/arithmetic.h"
#include "ir/eval/interpreter.h"

#include <set>

namespace glider::ir {
namespace {

/// The greatest age (s) of a sensor in a reading that a window takes.
constexpr double kFreshAge = 6;

/// The sensors that an expression reads.
void addSensors(const Mission& mission, ExprId id, std::set<uint32_t>& sensors) {
  std::set<uint32_t> pending = {id.index};
  while (!pending.empty()) {
    const Expr& e = mission.exprs.at(*pending.rbegin());  // operands have smaller numbers
    pending.erase(std::prev(pending.end()));
    if (e.op == Op::Sensor) {
      sensors.insert(e.sensor.index);
    }
    for (uint32_t k = 0; k < operandCount(e); ++k) {
      pending.insert(e.operands.at(k).index);
    }
  }
}

}  // namespace

bool Interpreter::current(const Temporal& temporal) const {
  return temporal.list == ListKind::Always || temporal.state == state_;
}

/// The temporals of `always`, or those of the current state, start, continue after a return, or
/// advance. The order is visible in the calls of C functions.
void Interpreter::startTemporals(bool always, TemporalMoment moment) {
  for (uint32_t i = 0; i < temporals_.size(); ++i) {
    const Temporal& t = mission_.temporals[i];
    if (current(t) && (t.list == ListKind::Always) == always) {
      update(i, moment);
    }
  }
}

void Interpreter::update(uint32_t temporal, TemporalMoment moment) {
  const Temporal& t = mission_.temporals[temporal];
  if (t.leg != Leg::None) {
    updateLeg(t, temporals_[temporal], moment == TemporalMoment::Start);
  } else if (isWindow(t.kind)) {
    updateWindow(t, temporals_[temporal], moment == TemporalMoment::Start);
  } else {
    updateGuard(t, temporals_[temporal], moment != TemporalMoment::Advance);
  }
}

void Interpreter::updateGuard(const Temporal& t, TemporalState& state, bool start) {
  const Truth operand = truthOf(t.operand);
  const bool turned = operand == Truth::True && !state.was_true && !start;
  if (t.kind == TemporalKind::Became) {
    state.value = operand == Truth::Unknown ? Truth::Unknown : truth(turned);
  } else {
    if (start || turned) {
      state.since = mission_time_;
    }
    const double held = settle(mission_time_ - state.since);
    const double duration = number(t.duration);
    state.value = operand == Truth::True ? compare(Op::GreaterEqual, held, duration) : operand;
  }
  state.was_true = operand == Truth::True;
}

void Interpreter::updateWindow(const Temporal& t, TemporalState& state, bool start) {
  if (start) {
    state.window.emplace(windowShape(t));
    state.window->start(mission_time_);
  }
  const double along = t.along.valid() ? number(t.along) : mission_time_;
  state.window->advance(mission_time_, along, number(t.operand), fresh(t));
  state.value = state.window->value();
}

void Interpreter::updateLeg(const Temporal& t, TemporalState& state, bool start) {
  if (start) {
    state.legs.emplace(t);
    state.legs->start(mission_time_);
  }
  const double operand = number(t.operand);
  const double other = t.duration.valid() ? number(t.duration) : operand;
  const bool of_operand = t.kind == TemporalKind::Steepest;
  state.legs->advance(mission_time_, number(t.along), of_operand ? operand : other,
                      of_operand ? other : operand, fresh(t));
  state.value = state.legs->value();
}

/// Whether the sensors that a window reads are new.
bool Interpreter::fresh(const Temporal& window) const {
  std::set<uint32_t> sensors;
  addSensors(mission_, window.operand, sensors);
  if (window.along.valid() && window.leg == Leg::None) {
    addSensors(mission_, window.along, sensors);
  }
  if (window.duration.valid()) {
    addSensors(mission_, window.duration, sensors);
  }
  bool new_one = sensors.empty();
  for (uint32_t i : sensors) {
    if (age({i}) > kFreshAge) {
      return false;
    }
    new_one |= age({i}) == 0;
  }
  return new_one;
}

}  // namespace glider::ir
