// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/random_flight.h"

#include "ir/prove/random_vehicle.h"
#include "ir/prove/run_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::ir::prove {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kFar = 1e9;  ///< of a range without an end
constexpr double kLostTick = 0.01;

/// What a sensor shows for a while.
struct Showing {
  double value = kUnknown;
  bool steady = true;  ///< else another value in every tick
  double until = 0;    ///< mission time
};

class RandomFlight {
 public:
  RandomFlight(const Ground& ground, uint32_t stack_depth, const Requirement& requirement,
               uint64_t seed)
      : ground_(ground),
        m_(ground.mission),
        recorder_(ground, stack_depth, requirement),
        dice_(seed),
        vehicle_(ground.platform, dice_),
        showing_(m_.sensors.size()) {}

  std::optional<ConcreteRun> fly(size_t ticks) {
    double time = 0;
    recorder_.start(parameters(), readings(time), vehicle_.depth());
    for (size_t i = 0; i < ticks && !recorder_.hit() && !recorder_.last().finished; ++i) {
      vehicle_.obey(recorder_.last().actions, time);
      const double step = dice_.chance(kLostTick) ? ground_.platform.world.tick_gap_s
                                                  : ground_.platform.envelope.cycle_s;
      vehicle_.move(time, time + step);
      time += step;
      recorder_.tick(time, readings(time), vehicle_.depth());
    }
    return recorder_.hit() ? std::optional(recorder_.take()) : std::nullopt;
  }

 private:
  /// Within their ranges and conditions; the defaults if none are found.
  std::vector<double> parameters() {
    constexpr int kTries = 30;
    for (int i = 0; i < kTries; ++i) {
      std::vector<double> values = defaultParameters(m_);
      size_t number = 0;
      for (const Variable& variable : m_.variables) {
        if (variable.kind == VariableKind::Parameter) {
          double& value = values[number++];
          value = anyParameter(variable, value);
        }
      }
      if (!failedCondition(m_, values)) {
        return values;
      }
    }
    return defaultParameters(m_);
  }

  double anyParameter(const Variable& variable, double standard) {
    if (variable.type.kind == TypeKind::Bool) {
      return dice_.below(2);
    }
    switch (dice_.below(4)) {
      case 0:
        return standard;
      case 1:
        return variable.lowest;
      case 2:
        return variable.highest;
      default:
        return dice_.within(std::max(variable.lowest, -kFar), std::min(variable.highest, kFar));
    }
  }

  std::vector<double> readings(double time) {
    std::vector<double> values;
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      Showing& now = showing_[i];
      if (time >= now.until) {
        now = {anyValue(i), dice_.chance(0.7), time + dice_.lasting()};
      } else if (!now.steady) {
        now.value = anyValue(i);
      }
      const bool depth = recorder_.depthSensor() == SensorId{i};
      values.push_back(depth && now.value == now.value ? vehicle_.reading() : now.value);
    }
    return values;
  }

  /// Of a sensor: within its range, at its ends, next to a constant of its type, or unknown.
  double anyValue(uint32_t sensor) {
    const Interval& range = ground_.sensors[sensor];
    if (range.empty || dice_.chance(0.1)) {
      return kUnknown;
    }
    const double lowest = std::max(range.lowest, -kFar);
    const double highest = std::min(range.highest, kFar);
    if (dice_.chance(0.4)) {
      const Expr& e = m_.exprs[dice_.below(m_.exprs.size())];
      if (e.op == Op::Constant && e.type == m_.sensors[sensor].type) {
        const double near = e.number + dice_.within(-1, 1) * std::max(1e-3, e.number * 0.01);
        return std::clamp(near, lowest, highest);
      }
    }
    return dice_.within(lowest, highest);
  }

  const Ground& ground_;
  const Mission& m_;
  RunRecorder recorder_;
  Dice dice_;
  RandomVehicle vehicle_;
  std::vector<Showing> showing_;
};

}  // namespace

std::optional<ConcreteRun> flyAtRandom(const Ground& ground, uint32_t stack_depth,
                                       const Requirement& requirement, uint64_t seed,
                                       size_t ticks) {
  return RandomFlight(ground, stack_depth, requirement, seed).fly(ticks);
}

}  // namespace glider::ir::prove
