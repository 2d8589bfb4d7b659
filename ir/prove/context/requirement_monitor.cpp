// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/requirement_monitor.h"

#include <span>

namespace glider::ir {

RequirementMonitor::RequirementMonitor(const Mission& mission, const Requirement& requirement,
                                       double surface_depth_m, std::optional<SensorId> depth)
    : m_(mission), requirement_(requirement), surface_depth_m_(surface_depth_m), depth_(depth) {}

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

bool RequirementMonitor::conditionIsFalse(const Interpreter& run, double true_depth) const {
  const auto leaf = [&](const Expr& e, std::span<const double>) -> Value {
    if (e.op == Op::Sensor && depth_ && e.sensor == *depth_ && true_depth == true_depth) {
      return true_depth;
    }
    return run.evaluate({static_cast<uint32_t>(&e - m_.exprs.data())});
  };
  return std::get<Truth>(evaluate(m_, requirement_.condition, leaf)) == Truth::False;
}

void RequirementMonitor::tick(const Interpreter& run, double mission_time, const TickResult& result,
                              double true_depth) {
  if (finished_) {
    return;
  }
  if (true_depth <= surface_depth_m_) {
    last_surface_ = mission_time;
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

}  // namespace glider::ir
