// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/heard_ticks.h"

#include <algorithm>

namespace glider::flights {

std::vector<ir::SensorUpdate> frameOf(const ir::Mission& mission, const GliderContext& context) {
  std::vector<ir::SensorUpdate> frame;
  for (uint32_t i = 0; i < context.mission->sensor_count; ++i) {
    const GliderReading& reading = context.readings[i];
    const auto sensor =
        std::ranges::find(mission.sensors, context.mission->sensors[i].id, &ir::Sensor::id);
    if (reading.seen != 0 && reading.updated == context.mission_time &&
        sensor != mission.sensors.end()) {
      frame.push_back({{static_cast<uint32_t>(sensor - mission.sensors.begin())}, reading.raw});
    }
  }
  return frame;
}

void HeardTicks::look(const GliderContext& context, double now_s) {
  const double time = context.mission_time;
  const double last = ticks_.empty() ? -1 : ticks_.back().mission_time;
  over_ = over_ || time < last;  // another mission has begun
  if (over_ || time == last) {
    return;
  }
  ticks_.push_back({time, now_s, frameOf(m_, context)});
}

}  // namespace glider::flights
