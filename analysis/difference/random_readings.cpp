// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/difference/random_readings.h"

#include "ir/core/ops.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::analysis {
namespace {

constexpr double kCycle = 4;  ///< s, the usual one

double rawOf(const ir::Sensor& sensor, double value) {
  if (sensor.encoding != ir::Encoding::DegreesMinutes) {
    return value / sensor.to_si;
  }
  const double degrees = std::floor(std::abs(value));
  return std::copysign(100 * degrees + 60 * (std::abs(value) - degrees), value);
}

}  // namespace

RandomReadings::RandomReadings(const ir::Mission& before, const ir::Mission& after, uint64_t seed)
    : rng_(seed), longest_gap_(std::min(before.resume_within_s, after.resume_within_s)) {
  for (const ir::Mission* mission : {&before, &after}) {
    add(*mission);
  }
  for (const ir::Mission* mission : {&before, &after}) {
    for (const ir::Sensor& one : mission->sensors) {
      const auto same = std::ranges::find(sensors_, one.vehicle_name, &Sensor::vehicle_name);
      addConstants(before, one, *same);
      addConstants(after, one, *same);
    }
  }
}

void RandomReadings::add(const ir::Mission& mission) {
  for (const ir::Sensor& one : mission.sensors) {
    if (std::ranges::find(sensors_, one.vehicle_name, &Sensor::vehicle_name) == sensors_.end()) {
      sensors_.push_back({one.vehicle_name, {}, one.lowest, one.highest, 0, 0});
    }
  }
}

void RandomReadings::addConstants(const ir::Mission& mission, const ir::Sensor& of,
                                  Sensor& sensor) const {
  for (const ir::Expr& e : mission.exprs) {
    const double raw = e.op == ir::Op::Constant && e.type == of.type ? rawOf(of, e.number) : NAN;
    if (raw >= sensor.lowest && raw <= sensor.highest &&
        std::ranges::find(sensor.often, raw) == sensor.often.end()) {
      sensor.often.push_back(raw);
    }
  }
}

double RandomReadings::draw(const Sensor& sensor) {
  if (rng_.chance(0.05)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (sensor.often.empty() || rng_.chance(0.3)) {
    return rng_.within(sensor.lowest, sensor.highest);
  }
  const double near = sensor.often[rng_.below(sensor.often.size())];
  const double width = rng_.chance(0.5) ? 0.1 : 0.001;
  const double raw = near + width * (std::abs(near) + 1) * rng_.within(-1, 1);
  return std::clamp(raw, sensor.lowest, sensor.highest);
}

void RandomReadings::next() {
  if (started_) {
    mission_time_ +=
        rng_.chance(0.95) ? kCycle : rng_.within(kCycle, std::max(kCycle, longest_gap_));
  }
  started_ = true;
  for (Sensor& sensor : sensors_) {
    if (mission_time_ >= sensor.until) {
      sensor.raw = draw(sensor);
      sensor.until = mission_time_ + std::min(rng_.lasting(), 3600.0);
    }
  }
}

std::vector<ir::SensorUpdate> RandomReadings::frame(const ir::Mission& mission) const {
  std::vector<ir::SensorUpdate> updates;
  for (uint32_t i = 0; i < mission.sensors.size(); ++i) {
    const auto same =
        std::ranges::find(sensors_, mission.sensors[i].vehicle_name, &Sensor::vehicle_name);
    updates.push_back({{i}, same->raw});
  }
  return updates;
}

}  // namespace glider::analysis
