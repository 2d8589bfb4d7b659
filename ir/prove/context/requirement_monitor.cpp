// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/requirement_monitor.h"

#include <algorithm>
#include <limits>
#include <span>

namespace glider::ir {

RequirementMonitor::RequirementMonitor(const Mission& mission, const Requirement& requirement,
                                       double surface_depth_m, std::optional<SensorId> depth)
    : m_(mission),
      requirement_(requirement),
      surface_depth_m_(surface_depth_m),
      depth_(depth),
      evaluations_(std::make_shared<Evaluations>(mission)),
      memory_(mission.variables.size(), std::numeric_limits<double>::quiet_NaN()) {}

/// By goto or call, or as the first state of the mission.
bool RequirementMonitor::enters(const TickResult& result, StateId state) const {
  if (!started_) {
    return result.state == state;
  }
  if (!result.moved || result.state != state || result.finished) {
    return false;
  }
  const auto& cases = result.moved->list == ListKind::Always ? m_.always : m_[before_].cases;
  return cases.at(result.moved->number).transition != Transition::Return;
}

Value RequirementMonitor::valueOf(ExprId id, const Interpreter& run, double true_depth) const {
  const auto leaf = [&](const Expr& e, std::span<const double>) -> Value {
    if (e.op == Op::Sensor && depth_ && e.sensor == *depth_ && true_depth == true_depth) {
      return true_depth;
    }
    if (e.op == Op::Variable && isOfMonitor(m_[e.variable].kind)) {
      return asValue(memory_[e.variable.index], m_[e.variable].type);
    }
    if (e.op == Op::MissionTime && still_) {
      return *still_;
    }
    return run.evaluate({static_cast<uint32_t>(&e - m_.exprs.data())});
  };
  return evaluations_->of(id)(leaf);
}

bool RequirementMonitor::conditionIsFalse(const Interpreter& run, double true_depth) const {
  return std::get<Truth>(valueOf(requirement_.condition, run, true_depth)) == Truth::False;
}

bool RequirementMonitor::observed(const Observation& observation, const TickResult& result) const {
  switch (observation.kind) {
    case ObservationKind::Entered:
      return enters(result, observation.state);
    case ObservationKind::Inside:
      return result.state == observation.state ||
             std::ranges::find(result.stack, observation.state, &Frame::state) !=
                 result.stack.end();
    case ObservationKind::Ended:
      break;
  }
  return result.finished;
}

/// The end of a tick, for the monitor (ir/README.md, Monitors).
void RequirementMonitor::watch(const Interpreter& run, const TickResult& result,
                               double true_depth) {
  const Monitor& monitor = requirement_.monitor;
  for (uint32_t i = 0; i < memory_.size(); ++i) {
    const Variable& v = m_.variables[i];
    if (v.kind == VariableKind::Momentary) {
      memory_[i] = std::numeric_limits<double>::quiet_NaN();
    } else if (v.kind == VariableKind::Monitor && !started_) {
      memory_[i] = asNumber(valueOf(v.initial, run, true_depth));
    }
  }
  for (const Observation& observation : monitor.observations) {
    memory_[observation.variable.index] = observed(observation, result) ? 1 : 0;
  }
  execute(monitor.step, run, true_depth);
  for (const Violation& violation : monitor.violations) {
    if (words_.empty() &&
        std::get<Truth>(valueOf(violation.condition, run, true_depth)) == Truth::True) {
      words_ = violation.words;
      if (violation.since.valid()) {
        due_ = {memory_[violation.since.index], violation.cause};
      }
    }
  }
}

/// S1 and S2, without notes.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the monitor's statements nest
void RequirementMonitor::execute(BlockId block, const Interpreter& run, double true_depth) {
  if (!block.valid()) {
    return;
  }
  for (const Statement& s : m_[block].statements) {
    const Value value = valueOf(s.value, run, true_depth);
    if (s.kind == StatementKind::Set) {
      const double number = asNumber(value);
      double& held = memory_[s.variable.index];
      held = number == number ? number : held;
    } else if (s.kind == StatementKind::If) {
      const Truth condition = std::get<Truth>(value);
      execute(condition == Truth::True    ? s.then
              : condition == Truth::False ? s.otherwise
                                          : BlockId(),
              run, true_depth);
    }
  }
}

void RequirementMonitor::tick(const Interpreter& run, double mission_time, const TickResult& result,
                              double true_depth) {
  if (finished_) {
    return;
  }
  if (true_depth <= surface_depth_m_) {
    last_surface_ = mission_time;
  }
  if (requirement_.monitor.step.valid()) {
    watch(run, result, true_depth);
  }
  bool hit = false;
  switch (requirement_.kind) {
    case RequirementKind::Always:
      hit = conditionIsFalse(run, true_depth);
      break;
    case RequirementKind::ExitWithin:
      hit = mission_time > requirement_.seconds;
      break;
    case RequirementKind::StackAtMost:
      hit = result.stack.size() > requirement_.depth;
      break;
    case RequirementKind::Reach:
      hit = enters(result, requirement_.state);
      break;
    case RequirementKind::NeverAfter:
      hit = after_seen_ && enters(result, requirement_.state);
      after_seen_ = after_seen_ || enters(result, requirement_.after);
      break;
    case RequirementKind::SurfacesEvery:
      hit = true_depth == true_depth && mission_time - last_surface_ > requirement_.seconds;
      break;
  }
  if (hit && !when_) {
    when_ = mission_time;
  }
  started_ = true;
  finished_ = result.finished;
  before_ = result.state;
}

void RequirementMonitor::still(const Interpreter& run, double mission_time, const TickResult& last,
                               double true_depth) {
  TickResult none = last;
  none.moved.reset();
  still_ = mission_time;
  tick(run, mission_time, none, true_depth);
  still_.reset();
}

bool RequirementMonitor::owes(const Interpreter& run, double mission_time, const TickResult& last,
                              double true_depth) const {
  constexpr double kMoreThanAnyClock_s = 1;
  const double time = std::max(requirement_.seconds, requirement_.monitor.horizon_s);
  if (!(time > 0) || finished_ || when_) {
    return false;
  }
  RequirementMonitor later = *this;
  later.still(run, mission_time + time + kMoreThanAnyClock_s, last, true_depth);
  return later.when_.has_value();
}

}  // namespace glider::ir
