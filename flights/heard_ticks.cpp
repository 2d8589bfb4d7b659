// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/heard_ticks.h"

#include <algorithm>

namespace glider::flights {

void HeardTicks::look(const GliderContext& context, double now_s) {
  const double time = context.mission_time;
  const double last = ticks_.empty() ? -1 : ticks_.back().mission_time;
  over_ = over_ || time < last;  // another mission has begun
  if (over_ || time == last) {
    return;
  }
  HeardTick tick{time, now_s, {}};
  for (uint32_t i = 0; i < context.mission->sensor_count; ++i) {
    const GliderReading& reading = context.readings[i];
    const auto sensor =
        std::ranges::find(m_.sensors, context.mission->sensors[i].id, &ir::Sensor::id);
    if (reading.seen != 0 && reading.updated == time && sensor != m_.sensors.end()) {
      tick.frame.push_back({{static_cast<uint32_t>(sensor - m_.sensors.begin())}, reading.raw});
    }
  }
  ticks_.push_back(std::move(tick));
}

}  // namespace glider::flights
