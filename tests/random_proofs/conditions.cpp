// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/conditions.h"

#include <algorithm>
#include <cmath>

namespace glider::random_proofs {

using ir::ExprId;
using ir::Op;

namespace {

const ir::Type kTime = ir::quantity(support::dimension::time);

}  // namespace

Conditions::Conditions(ir::Mission& mission, const Bounds& bounds, random_missions::Random& random)
    : m_(mission), bounds_(bounds), random_(random), write_(mission, "condition", {}) {
  for (const ir::Expr& e : m_.exprs) {
    if (e.op == Op::Constant && e.type == kTime && e.number > 0) {
      named_.push_back(e.number);
    }
  }
}

double Conditions::near(double value) {
  constexpr double kSteps[] = {0, 0, 0, 1e-6, 0.5, 1, 4, 20};
  const double step = random_.pick(kSteps);
  return random_.chance(0.5) ? value + step : value - step;
}

double Conditions::time() {
  const Scouted& s = bounds_.scouted;
  const double scouted[] = {s.latest, s.statetime, s.resumetime, s.below};
  double value = random_.pick(scouted);
  const double kind = random_.unit();
  if (kind < 0.3 && bounds_.ends_by) {
    value = *bounds_.ends_by;
  } else if (kind < 0.5) {
    value = named_.empty() ? value : random_.pick(named_);
  }
  return std::max(1.0, near(random_.chance(0.2) ? value + m_.resume_within_s : value));
}

ExprId Conditions::compare(Op op, ExprId a, double b) {
  return write_.operation(op, ir::boolean(), {a, write_.number(b, m_[a].type)});
}

ExprId Conditions::clock(Op op) {
  return write_.operation(op, kTime, {});
}

ExprId Conditions::ofClock() {
  const Scouted& s = bounds_.scouted;
  const double kind = random_.unit();
  if (kind < 0.35) {
    const double by = bounds_.ends_by && random_.chance(0.6) ? *bounds_.ends_by : s.latest;
    return compare(Op::LessEqual, clock(Op::MissionTime), near(by));
  }
  if (kind < 0.55) {
    return compare(Op::LessEqual, clock(Op::StateTime), near(s.statetime));
  }
  if (kind < 0.75) {
    return compare(Op::LessEqual, clock(Op::ResumeTime), near(s.resumetime));
  }
  constexpr Op kClocks[] = {Op::MissionTime, Op::StateTime, Op::ResumeTime};
  return compare(random_.chance(0.5) ? Op::GreaterEqual : Op::Less, clock(random_.pick(kClocks)),
                 time());
}

ExprId Conditions::reading(ir::SensorId sensor) {
  return write_.read(sensor);
}

std::optional<ir::SensorId> Conditions::measured(std::optional<ir::SensorId> not_this) {
  std::vector<ir::SensorId> found;
  for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
    const ir::Sensor& sensor = m_.sensors[i];
    if (not_this != ir::SensorId{i} && sensor.type.kind == ir::TypeKind::Quantity &&
        sensor.encoding == ir::Encoding::Linear) {
      found.push_back({i});
    }
  }
  return found.empty() ? std::nullopt : std::optional(random_.pick(found));
}

ExprId Conditions::ofSensor() {
  const auto sensor = measured({});
  if (!sensor) {
    return write_.truth(true);
  }
  const ExprId value = reading(*sensor);
  if (random_.chance(0.3)) {
    return write_.operation(Op::Known, ir::boolean(), {value});
  }
  const double low = std::clamp(m_[*sensor].lowest * m_[*sensor].to_si, -1e6, 1e6);
  const double high = std::clamp(m_[*sensor].highest * m_[*sensor].to_si, -1e6, 1e6);
  const double limits[] = {low, high, random_.uniform(low, high)};
  return compare(random_.chance(0.5) ? Op::LessEqual : Op::GreaterEqual, value,
                 near(random_.pick(limits)));
}

ExprId Conditions::depthAtMost(double depth) {
  for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
    if (m_.sensors[i].vehicle_name == "m_depth") {
      return compare(random_.chance(0.3) ? Op::Less : Op::LessEqual, reading({i}), depth);
    }
  }
  return ofClock();
}

ExprId Conditions::ofDepth() {
  const bool proved = bounds_.deepest && random_.chance(0.5);
  return depthAtMost(near(proved ? *bounds_.deepest : bounds_.scouted.deepest));
}

ExprId Conditions::ofVariable(bool parameter) {
  std::vector<uint32_t> found;
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    const ir::VariableKind kind = m_.variables[i].kind;
    if (kind == ir::VariableKind::Parameter || (kind == ir::VariableKind::Mission && !parameter)) {
      found.push_back(i);
    }
  }
  if (found.empty()) {
    return ofSensor();
  }
  const uint32_t chosen = random_.pick(found);
  const ExprId value = write_.read(ir::VariableId{chosen});
  const ir::Variable& v = m_.variables[chosen];
  if (v.type.kind == ir::TypeKind::Bool) {
    return random_.chance(0.5) ? value : write_.negation(value);
  }
  const bool above = random_.chance(0.3);
  const bool seen = chosen < bounds_.scouted.lowest.size() && random_.chance(0.8);
  double limit = above ? v.lowest : v.highest;
  limit = seen ? (above ? bounds_.scouted.lowest : bounds_.scouted.highest)[chosen] : limit;
  return compare(above ? Op::GreaterEqual : Op::LessEqual, value,
                 std::isfinite(limit) ? near(limit) : 0);
}

ExprId Conditions::simple() {
  const double kind = random_.unit();
  return kind < 0.35   ? ofClock()
         : kind < 0.55 ? ofDepth()
         : kind < 0.85 ? ofVariable(false)
                       : ofSensor();
}

ExprId Conditions::any() {
  const ExprId first = simple();
  const double kind = random_.unit();
  if (kind < 0.4) {
    return first;
  }
  const ExprId second = simple();
  return kind < 0.6   ? write_.both(first, second)
         : kind < 0.8 ? write_.either(first, second)
                      : write_.either(write_.negation(first), second);
}

ExprId Conditions::ofReadings() {
  const auto one = [&] {
    const double kind = random_.unit();
    return kind < 0.2   ? compare(Op::LessEqual, clock(Op::MissionTime), time())
           : kind < 0.4 ? ofVariable(true)
                        : ofSensor();
  };
  const ExprId first = one();
  return random_.chance(0.5) ? first : write_.either(first, one());
}

}  // namespace glider::random_proofs
