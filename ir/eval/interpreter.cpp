// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/interpreter.h"

#include "ir/core/validate.h"
#include "ir/eval/arithmetic.h"
#include "support/check.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace glider::ir {

Interpreter::Interpreter(const Mission& mission, uint32_t stack_depth)
    : mission_(mission),
      stack_depth_(stack_depth),
      sensors_(mission.sensors.size()),
      values_(mission.exprs.size()) {
  CHECK(validate(mission).empty(), "a mission that does not hold together");
}

TickResult Interpreter::start(std::span<const SensorUpdate> frame) {
  CHECK(!started_, "a mission starts once");
  started_ = true;
  take(0, frame);
  evaluateAll();
  return result(std::nullopt, Phase::Enter);
}

TickResult Interpreter::tick(double mission_time, std::span<const SensorUpdate> frame) {
  CHECK(started_, "a tick before the start");
  CHECK(std::isfinite(mission_time), "mission time is a number");
  if (finished_) {
    return result(std::nullopt, Phase::Tick);
  }
  take(mission_time, frame);
  evaluateAll();
  const std::optional<uint32_t> fired = firstTrueCase();
  Phase phase = Phase::Tick;
  if (fired) {
    phase = fire(mission_[state_].cases[*fired]);
    evaluateAll();  // `statetime` and `resumetime` may have started anew
  }
  return result(fired, phase);
}

/// Steps 1 and 2 of a tick.
void Interpreter::take(double mission_time, std::span<const SensorUpdate> frame) {
  mission_time_ = std::max(mission_time_, mission_time);
  for (const SensorUpdate& update : frame) {
    SensorState& sensor = sensors_.at(update.sensor.index);
    sensor.raw = update.raw;
    sensor.updated = mission_time_;
    sensor.seen = true;
  }
  for (uint32_t i = 0; i < sensors_.size(); ++i) {
    SensorState& sensor = sensors_[i];
    sensor.value = sensor.seen ? reading(mission_.sensors[i], sensor.raw, age({i})) : kUnknown;
  }
}

double Interpreter::age(SensorId id) const {
  return settle(mission_time_ - sensors_.at(id.index).updated);
}

/// Operands stand before their users, so one pass in order is enough.
void Interpreter::evaluateAll() {
  for (size_t i = 0; i < values_.size(); ++i) {
    values_[i] = valueOf(mission_.exprs[i]);
  }
}

Value Interpreter::valueOf(const Expr& e) const {
  auto a = [&](size_t i) { return number(e.operands.at(i)); };
  auto t = [&](size_t i) { return truthOf(e.operands.at(i)); };
  switch (e.op) {
    case Op::Constant:
      return e.number;
    case Op::True:
      return Truth::True;
    case Op::False:
      return Truth::False;
    case Op::Sensor:
      return readingOf(e.sensor);
    case Op::MissionTime:
      return mission_time_;
    case Op::StateTime:
      return settle(mission_time_ - entered_);
    case Op::ResumeTime:
      return settle(mission_time_ - resumed_);
    case Op::Age:
      return age(e.sensor);
    case Op::Negate:
    case Op::Abs:
    case Op::Sqrt:
      return unary(e.op, a(0));
    case Op::Add:
    case Op::Subtract:
    case Op::Multiply:
    case Op::Divide:
    case Op::Min:
    case Op::Max:
      return binary(e.op, a(0), a(1));
    case Op::Clamp:
      return clamp(a(0), a(1), a(2));
    case Op::Less:
    case Op::LessEqual:
    case Op::Greater:
    case Op::GreaterEqual:
    case Op::Equal:
    case Op::NotEqual:
      return compare(e.op, a(0), a(1));
    case Op::Known:
      return truth(isKnown(a(0)));
    case Op::Not:
      return logicalNot(t(0));
    case Op::And:
      return logicalAnd(t(0), t(1));
    case Op::Or:
      return logicalOr(t(0), t(1));
  }
  CHECK(false, "an operation without a meaning");
}

std::optional<uint32_t> Interpreter::firstTrueCase() const {
  const std::vector<Case>& cases = mission_[state_].cases;
  auto holds = [&](const Case& c) { return truthOf(c.guard) == Truth::True; };
  auto found = std::ranges::find_if(cases, holds);
  return found == cases.end() ? std::nullopt
                              : std::optional(static_cast<uint32_t>(found - cases.begin()));
}

/// Step 3: the transition; returns why the behaviours run next.
Phase Interpreter::fire(const Case& fired) {
  switch (fired.transition) {
    case Transition::Stay:
      return Phase::Tick;
    case Transition::Exit:
      finished_ = true;
      return Phase::Tick;
    case Transition::Return:
      CHECK(!stack_.empty(), "a return with nowhere to go");
      state_ = stack_.back().state;
      entered_ = stack_.back().entered;
      resumed_ = mission_time_;
      stack_.pop_back();
      return Phase::Resume;
    case Transition::Goto:
      stack_.clear();
      break;
    case Transition::Call:
      CHECK(stack_.size() < stack_depth_, "a call deeper than the verified stack");
      stack_.push_back({state_, entered_});
      break;
  }
  state_ = fired.target;
  entered_ = resumed_ = mission_time_;
  return Phase::Enter;
}

ActivityRun Interpreter::run(const Activity& activity, Phase phase) const {
  ActivityRun run{activity.behaviour, phase, {}};
  std::ranges::transform(activity.arguments, std::back_inserter(run.arguments),
                         [&](ExprId id) { return number(id); });
  return run;
}

/// Step 4, and the report of the tick.
TickResult Interpreter::result(std::optional<uint32_t> fired, Phase phase) const {
  TickResult result{state_, finished_, fired, stack_, {}, {}};
  if (!finished_) {
    result.profile = run(mission_[state_].profile, phase);
    result.route = run(mission_[state_].route, phase);
  }
  return result;
}

}  // namespace glider::ir
