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
}

Flight::Flight(const ir::prove::ProofContext& context, uint64_t seed, bool power_cuts)
    : context_(context),
      m_(context.mission),
      seed_(seed),
      power_cuts_(power_cuts),
      dice_(seed),
      vehicle_(context.platform, dice_),
      interpreter_(m_, static_cast<uint32_t>(2 * m_.states.size()),
                   random_missions::randomExternals()),
      showing_(m_.sensors.size()) {}

void Flight::start() {
  now_.depth = vehicle_.depth();
  const auto readings = frame();
  now_.result = interpreter_.start(readings, parameters());
  keepAges(readings);
}

/// Often the longest that there may be: what must happen by then has the least time.
double Flight::step() {
  const double cycle = context_.platform.envelope.cycle_s;
  const double gap = context_.platform.world.tick_gap_s;
  const double longest = power_cuts_ ? std::max(gap, m_.resume_within_s) : gap;
  const double kind = dice_.unit();
  return kind < 0.03   ? 0
         : kind < 0.7  ? cycle
         : kind < 0.8  ? gap
         : kind < 0.88 ? longest
                       : ir::prove::onVehicleClock(dice_.within(0, longest));
}

void Flight::advance() {
  before_ = now_;
  const double until = now_.time + step();
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

std::vector<double> Flight::parameters() {
  std::vector<double> values;
  for (const ir::Variable& v : m_.variables) {
    if (v.kind != ir::VariableKind::Parameter) {
      continue;
    }
    const double kind = dice_.unit();
    values.push_back(kind < 0.3 ? v.lowest
                     : kind < 0.6
                         ? v.highest
                         : std::clamp(dice_.within(v.lowest, v.highest), v.lowest, v.highest));
  }
  return values;
}

double Flight::raw(uint32_t index) {
  const ir::Sensor& sensor = m_.sensors[index];
  const double kind = dice_.unit();
  const double low = std::max(sensor.lowest, -1e9);
  const double high = std::min(sensor.highest, 1e9);
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
    if (!m_.sensors[i].symbol.empty() || dice_.chance(0.2)) {
      continue;
    }
    const bool depth = context_.depth == ir::SensorId{i} && !std::isnan(now.raw);
    frame.push_back({{i}, depth ? vehicle_.reading() : now.raw});
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
