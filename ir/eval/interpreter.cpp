// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The tick of ir/README.md: time, readings, temporals, lists, transitions.

#include "ir/eval/interpreter.h"

#include "ir/core/ops.h"
#include "ir/core/sampling.h"
#include "ir/core/validate.h"
#include "ir/eval/arithmetic.h"
#include "support/check.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::ir {

std::vector<double> defaultParameters(const Mission& mission) {
  std::vector<double> values;
  for (const Variable& v : mission.variables) {
    if (v.kind == VariableKind::Parameter) {
      values.push_back(asNumber(evaluate(mission, v.initial, {})));
    }
  }
  return values;
}

std::optional<uint32_t> failedCondition(const Mission& mission,
                                        std::span<const double> parameters) {
  auto leaves = [&](const Expr& e, std::span<const double>) {
    return asValue(parameters[e.variable.index], e.type);
  };
  for (uint32_t i = 0; i < mission.conditions.size(); ++i) {
    if (std::get<Truth>(evaluate(mission, mission.conditions[i], leaves)) != Truth::True) {
      return i;
    }
  }
  return std::nullopt;
}

Interpreter::Interpreter(const Mission& mission, uint32_t stack_depth, Externals externals)
    : mission_(mission),
      evaluations_(std::make_shared<Evaluations>(mission)),
      stack_depth_(stack_depth),
      sensors_(mission.sensors.size()),
      variables_(mission.variables.size(), kUnknown),
      temporals_(mission.temporals.size()),
      externals_(std::move(externals)),
      called_(mission.uses.size()) {
  CHECK(validate(mission).empty(), "a mission that does not hold together");
}

TickResult Interpreter::start(std::span<const SensorUpdate> frame) {
  return start(frame, defaultParameters(mission_));
}

TickResult Interpreter::start(std::span<const SensorUpdate> frame,
                              std::span<const double> parameters) {
  begin(frame, parameters);
  enter({0});
  return result();
}

TickResult Interpreter::startIn(StateId state, std::span<const double> arguments,
                                std::span<const SensorUpdate> frame,
                                std::span<const double> parameters) {
  begin(frame, parameters);
  const std::vector<VariableId>& formals = mission_[state].parameters;
  CHECK(arguments.size() == formals.size(), "a value for each parameter of the state");
  for (size_t i = 0; i < formals.size(); ++i) {
    assign(formals[i], arguments[i]);
  }
  enter(state);
  return result();
}

/// The start up to the first state.
void Interpreter::begin(std::span<const SensorUpdate> frame, std::span<const double> parameters) {
  CHECK(!started_, "a mission starts once");
  CHECK(parameters.size() == defaultParameters(mission_).size(), "a value for each parameter");
  started_ = true;
  take(0, frame);
  for (uint32_t i = 0; i < parameters.size(); ++i) {
    CHECK(isKnown(parameters[i]), "a parameter is known");
    assign({i}, parameters[i]);
  }
  initialise(false);
  startTemporals(true, TemporalMoment::Start);
  run(mission_.every_tick);
}

TickResult Interpreter::tick(double mission_time, std::span<const SensorUpdate> frame) {
  advance(mission_time, frame);
  return decide();
}

void Interpreter::advance(double mission_time, std::span<const SensorUpdate> frame) {
  CHECK(started_, "a tick before the start");
  CHECK(std::isfinite(mission_time), "mission time is a number");
  if (!finished_) {
    take(mission_time, frame);
    startTemporals(true, TemporalMoment::Advance);
    run(mission_.every_tick);
    startTemporals(false, TemporalMoment::Advance);
    if (samplingChanges(mission_, mission_[state_])) {
      sample();
    }
  }
}

TickResult Interpreter::decide() {
  if (finished_) {
    return result();
  }
  const bool own_first = std::exchange(just_returned_, false);
  const ListKind first = own_first ? ListKind::State : ListKind::Always;
  const ListKind second = own_first ? ListKind::Always : ListKind::State;
  for (ListKind list : {first, second, ListKind::Profile, ListKind::Route}) {
    if (tryList(list)) {
      break;
    }
  }
  return result();
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
  poll();
  std::ranges::fill(called_, std::nullopt);
  for (uint32_t i = 0; i < sensors_.size(); ++i) {
    SensorState& sensor = sensors_[i];
    sensor.value = sensor.seen ? reading(mission_.sensors[i], sensor.raw, age({i})) : kUnknown;
  }
}

/// Polls the SBC's own sensors.
void Interpreter::poll() {
  for (uint32_t i = 0; i < sensors_.size() && externals_.poll; ++i) {
    if (mission_.sensors[i].symbol.empty()) {
      continue;
    }
    const double raw = externals_.poll(mission_.sensors[i], mission_time_);
    if (!std::isnan(raw)) {
      sensors_[i] = {raw, mission_time_, true, kUnknown};
    }
  }
}

double Interpreter::called(UseId use, std::span<const double> arguments) const {
  std::optional<double>& value = called_.at(use.index);
  if (!value) {
    const Function& f = mission_[use];
    const double given = settle(externals_.call ? externals_.call(f, arguments) : kUnknown);
    value = given >= f.lowest && given <= f.highest ? given : kUnknown;
  }
  return *value;
}

double Interpreter::age(SensorId id) const {
  return settle(mission_time_ - sensors_.at(id.index).updated);
}

Value Interpreter::evaluate(ExprId id) const {
  return evaluations_->of(id)(
      [this](const Expr& e, std::span<const double> arguments) { return leaf(e, arguments); });
}

Value Interpreter::leaf(const Expr& e, std::span<const double> arguments) const {
  switch (groupOf(e.op)) {
    case OpGroup::Sensor:
      return readingOf(e.sensor);
    case OpGroup::Age:
      return age(e.sensor);
    case OpGroup::Clock:
      return clock(opIn<ClockOp>(e.op));
    case OpGroup::Variable:
      return asValue(variables_.at(e.variable.index), e.type);
    case OpGroup::Temporal:
      return temporals_.at(e.temporal.index).value;
    case OpGroup::Call:
      return asValue(called(e.use, arguments), e.type);
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
}

double Interpreter::clock(ClockOp op) const {
  switch (op) {
    case ClockOp::MissionTime:
      return mission_time_;
    case ClockOp::StateTime:
      return settle(mission_time_ - entered_);
    case ClockOp::ResumeTime:
      return settle(mission_time_ - resumed_);
  }
  CHECK(false, "a clock without a meaning");
}

const Activity& Interpreter::activity(ListKind list) const {
  return list == ListKind::Profile ? mission_[state_].profile : mission_[state_].route;
}

const std::vector<Case>& Interpreter::casesOf(ListKind list) const {
  switch (list) {
    case ListKind::Always:
      return mission_.always;
    case ListKind::State:
      return mission_[state_].cases;
    case ListKind::Profile:
    case ListKind::Route:
      break;
  }
  return activity(list).cases;
}

/// The rule of `always`, without the limit.
bool Interpreter::mayFire(ListKind list, uint32_t number) const {
  if (list != ListKind::Always) {
    return true;
  }
  const StateId target = mission_.always[number].target;
  const bool in_use =
      target == state_ || std::ranges::find(stack_, target, &Frame::state) != stack_.end();
  return !(target.valid() && in_use);
}

bool Interpreter::isHeldBack(uint32_t always_case) const {
  const bool tried = always_case < limit_ && mayFire(ListKind::Always, always_case);
  return !tried && truthOf(mission_.always[always_case].guard) == Truth::True;
}

/// Step 4 for one list: true if it ended the tick.
bool Interpreter::tryList(ListKind list) {
  const bool behaviour = list == ListKind::Profile || list == ListKind::Route;
  if (behaviour && !mission_[activity(list).behaviour].symbol.empty()) {
    call(list, Phase::Tick);
    return false;
  }
  const std::vector<Case>& cases = casesOf(list);
  const size_t end =
      list == ListKind::Always ? std::min<size_t>(limit_, cases.size()) : cases.size();
  for (uint32_t i = 0; i < end; ++i) {
    if (truthOf(cases[i].guard) == Truth::True && mayFire(list, i)) {
      return fire({list, i}, cases[i]);
    }
  }
  return false;
}

bool Interpreter::fire(CaseOf of, const Case& fired) {
  told_.fired.at(static_cast<size_t>(of.list)) = of.number;
  run(fired.action);
  if (fired.transition == Transition::Done) {
    variables_.at(activity(of.list).done.index) = 1;
  }
  if (staysIn(fired.transition)) {
    return false;
  }
  told_.moved = of;
  move(of, fired);
  return true;
}

void Interpreter::move(CaseOf of, const Case& fired) {
  if (fired.transition == Transition::Exit) {
    finished_ = true;
    return;
  }
  if (fired.transition == Transition::Return) {
    resume();
    return;
  }
  const std::vector<double> arguments = numbers(fired.arguments);
  const bool always = of.list == ListKind::Always;
  if (fired.transition == Transition::Call) {
    CHECK(stack_.size() < stack_depth_, "a call deeper than the verified stack");
    stack_.push_back({state_, entered_, limit_});
    limit_ = always ? of.number : limit_;
  } else {
    stack_.clear();
    limit_ = always ? of.number : kNoLimit;
  }
  const std::vector<VariableId>& parameters = mission_[fired.target].parameters;
  for (size_t i = 0; i < parameters.size(); ++i) {
    assign(parameters[i], arguments[i]);
  }
  enter(fired.target);
}

/// The parameters already have their arguments.
void Interpreter::enter(StateId target) {
  state_ = target;
  entered_ = resumed_ = mission_time_;
  initialise(true);
  startTemporals(false, TemporalMoment::Start);
  sample();
  run(mission_[state_].entry);
  startActivity(ListKind::Profile, Phase::Enter);
  startActivity(ListKind::Route, Phase::Enter);
}

void Interpreter::resume() {
  CHECK(!stack_.empty(), "a return with nowhere to go");
  state_ = stack_.back().state;
  entered_ = stack_.back().entered;
  limit_ = stack_.back().limit;
  stack_.pop_back();
  resumed_ = mission_time_;
  just_returned_ = true;
  startTemporals(false, TemporalMoment::Resume);
  sample();
  startActivity(ListKind::Profile, Phase::Resume);
  startActivity(ListKind::Route, Phase::Resume);
}

/// Commands how often the instruments read. An unknown word changes nothing.
void Interpreter::sample() {
  constexpr double kMost = kHookMostSampling;
  double word = 0;
  for (const Sampling& one : mission_[state_].sampling) {
    word += number(one.code) * samplingWeight(one.place);
  }
  sampling_ = word >= 0 && word <= kMost ? std::floor(word) : sampling_;
}

void Interpreter::startActivity(ListKind list, Phase phase) {
  if (mission_[activity(list).behaviour].symbol.empty()) {
    run(activity(list).entry);
  } else {
    call(list, phase);
  }
}

/// Initialises the variables of the current state, or those of the mission.
void Interpreter::initialise(bool of_state) {
  for (uint32_t i = 0; i < variables_.size(); ++i) {
    const Variable& v = mission_.variables[i];
    const bool starts = of_state ? v.owner == state_ && v.kind != VariableKind::Argument
                                 : v.kind == VariableKind::Mission;
    if (starts) {
      assign({i}, asNumber(evaluate(v.initial)));
    }
  }
}

TickResult Interpreter::result() {
  TickResult result = std::exchange(told_, {});
  result.state = state_;
  result.sampling = sampling_;
  result.finished = finished_;
  result.limit = limit_;
  result.just_returned = just_returned_;
  result.stack = stack_;
  result.variables = variables_;
  return result;
}

}  // namespace glider::ir
