// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/containment/flight.h"

#include "ir/prove/context/vehicle_clock.h"
#include "tests/random_missions/random_mission.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::containment {

namespace {
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kFar = 1e9;  ///< of a range without an end

ir::Externals externalsFor(const FlightStyle& style) {
  ir::Externals externals = random_missions::randomExternals();
  if (style.silent) {
    externals.poll = nullptr;
  }
  return externals;
}

}  // namespace

Flight::Flight(const ir::prove::ProofContext& context, uint64_t seed, const FlightStyle& style)
    : context_(context),
      m_(context.mission),
      environment_(style.environment != nullptr ? *style.environment : m_),
      seed_(seed),
      style_(style),
      dice_(seed),
      vehicle_(context.platform, dice_,
               style.late ? ir::prove::Manner::Late : ir::prove::Manner::Any),
      interpreter_(m_, static_cast<uint32_t>(2 * m_.states.size()), externalsFor(style)),
      showing_(m_.sensors.size()) {}

void Flight::start() {
  now_.depth = vehicle_.depth();
  const auto readings = frame();
  now_.result = interpreter_.start(readings, parameters());
  keepAges(readings);
}

double Flight::longestStep() const {
  const double gap = context_.platform.world.tick_gap_s;
  return style_.power_cuts ? std::max(gap, environment_.resume_within_s) : gap;
}

/// To a time that the mission names, by one of its clocks, or to just before it, if that is not too
/// far; at times as far as may be.
double Flight::pressingStep() {
  constexpr double kClockTick = 1.0 / 64;
  const double bases[] = {0, now_.entered, now_.resumed};
  const double base = bases[dice_.below(std::size(bases))];
  std::vector<double> steps;
  for (const ir::Expr& e : m_.exprs) {
    const bool time = e.op == ir::Op::Constant && e.type.kind == ir::TypeKind::Quantity &&
                      e.type.dimension == support::dimension::time;
    const double step = time ? ir::prove::onVehicleClock(base + e.number) - now_.time : 0;
    if (step > kClockTick && step <= longestStep()) {
      steps.push_back(step);
    }
  }
  if (steps.empty() || dice_.chance(0.3)) {
    return longestStep();
  }
  return steps[dice_.below(steps.size())] - (dice_.chance(0.6) ? kClockTick : 0);
}

/// Often the longest that there may be: what must happen by then has the least time.
double Flight::step() {
  if (style_.pressing && dice_.chance(0.5)) {
    return pressingStep();
  }
  const double cycle = context_.platform.envelope.cycle_s;
  const double gap = context_.platform.world.tick_gap_s;
  const double longest = longestStep();
  const double kind = dice_.unit();
  return kind < 0.03   ? 0
         : kind < 0.7  ? cycle
         : kind < 0.8  ? gap
         : kind < 0.88 ? longest
                       : ir::prove::onVehicleClock(dice_.within(0, longest));
}

void Flight::advance(double seconds) {
  before_ = now_;
  const double until = now_.time + seconds;
  vehicle_.obey(now_.result.actions, now_.time);
  const double gap = context_.platform.world.tick_gap_s;
  for (double time = now_.time; time < until; time += gap) {
    vehicle_.move(time, std::min(time + gap, until));
  }
  now_.time = until;
  now_.depth = vehicle_.depth();
  const auto readings = frame();
  interpreter_.advance(until, readings);
  keepAges(readings);
}

void Flight::decide() {
  const auto waiting = now_.result.stack;
  now_.result = interpreter_.decide();
  if (arrived()) {
    now_.resumed = now_.time;
    const bool returned = now_.result.just_returned;
    now_.entered = returned ? waiting.back().entered : now_.time;
  }
}

void Flight::keepAges(const std::vector<ir::SensorUpdate>& frame) {
  for (const ir::SensorUpdate& update : frame) {
    came_[update.sensor.index] = now_.time;
  }
  now_.ages.assign(m_.sensors.size(), 0);
  for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
    now_.ages[i] = now_.time - (came_.contains(i) ? came_.at(i) : 0);
  }
}

/// Such that the mission's conditions hold; the defaults if none are found.
std::vector<double> Flight::parameters() {
  constexpr int kTries = 30;
  for (int i = 0; i < kTries; ++i) {
    std::vector<double> values = anyParameters();
    if (!ir::failedCondition(m_, values)) {
      return values;
    }
  }
  return ir::defaultParameters(m_);
}

std::vector<double> Flight::anyParameters() {
  std::vector<double> values;
  for (const ir::Variable& v : m_.variables) {
    if (v.kind != ir::VariableKind::Parameter) {
      continue;
    }
    if (v.type.kind == ir::TypeKind::Bool) {
      values.push_back(dice_.below(2));
      continue;
    }
    const double lowest = std::max(v.lowest, -kFar);
    const double highest = std::min(v.highest, kFar);
    const double kind = dice_.unit();
    values.push_back(kind < 0.3   ? lowest
                     : kind < 0.6 ? highest
                                  : std::clamp(dice_.within(lowest, highest), lowest, highest));
  }
  return values;
}

/// A raw value near to a number that the mission names, in the sensor's range.
std::optional<double> Flight::landmark(uint32_t index) {
  const ir::Sensor& sensor = environment_.sensors[index];
  std::vector<double> found;
  for (const ir::Expr& e : m_.exprs) {
    if (e.op == ir::Op::Constant && e.type == m_.sensors[index].type) {
      found.push_back(e.number / sensor.to_si);
    }
  }
  if (found.empty() || sensor.encoding == ir::Encoding::DegreesMinutes) {
    return std::nullopt;
  }
  const double at = found[dice_.below(found.size())];
  const double near = dice_.chance(0.3) ? at : at + 0.01 * std::fabs(at) * dice_.within(-1, 1);
  return near >= sensor.lowest && near <= sensor.highest ? std::optional(near) : std::nullopt;
}

double Flight::raw(uint32_t index) {
  const ir::Sensor& sensor = environment_.sensors[index];
  if (style_.pressing && dice_.chance(0.4)) {
    if (const auto near = landmark(index)) {
      return *near;
    }
  }
  const double kind = dice_.unit();
  const double low = std::max(sensor.lowest, -kFar);
  const double high = std::min(sensor.highest, kFar);
  if (kind < 0.15) {
    return kUnknown;
  }
  if (kind < 0.35) {
    return dice_.chance(0.5) ? low : high;
  }
  if (kind < 0.5) {
    return std::clamp(std::round(dice_.within(low, high)), low, high);
  }
  return dice_.within(low, high);
}

/// A sensor shows the same for a while, changes with each tick, or is silent.
std::vector<ir::SensorUpdate> Flight::frame() {
  std::vector<ir::SensorUpdate> frame;
  for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
    Showing& now = showing_[i];
    if (now_.time >= now.until) {
      now = {raw(i), dice_.chance(0.6), now_.time + dice_.lasting()};
    } else if (!now.steady) {
      now.raw = raw(i);
    }
    const bool depth = context_.depth == ir::SensorId{i};
    if (!m_.sensors[i].symbol.empty() || style_.silent) {
      continue;
    }
    if (dice_.chance(0.2) && (!depth || style_.old_depths)) {
      continue;
    }
    frame.push_back({{i}, depth && !std::isnan(now.raw) ? vehicle_.reading() : now.raw});
  }
  return frame;
}

std::string Flight::words() const {
  return fmt::format("mission {}, flight {}, at {} s in {}", m_.name, seed_, now_.time,
                     m_[now_.result.state].name);
}

ir::prove::Control controlOf(const ir::TickResult& result) {
  using ir::prove::Control;
  const auto limit = [](ir::Limit l) {
    return l == ir::kNoLimit ? Control::kNoLimit : uint32_t{l};
  };
  Control control{result.state, {}, limit(result.limit), result.just_returned};
  for (const ir::Frame& frame : result.stack) {
    control.stack.push_back({frame.state, limit(frame.limit)});
  }
  return control;
}

}  // namespace glider::containment
