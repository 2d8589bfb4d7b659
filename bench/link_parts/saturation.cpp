// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "bench/link_parts/saturation.h"

#include "tests/slocum.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::bench {
namespace {

/// The first `count` sensors of the platform that a vehicle reports of itself and the water.
std::vector<Subscription> sensorsToSubscribe(size_t count) {
  std::vector<Subscription> sensors;
  for (uint16_t id = 0; id < GLIDER_SENSOR_COUNT && sensors.size() < count; ++id) {
    const bool of_hook = isInstructionSensor(id) || id == GLIDER_SCI_HOOK_HEARTBEAT ||
                         (id >= GLIDER_X_HOOK_STATE && id <= GLIDER_X_HOOK_SESSION);
    if (!of_hook) {
      sensors.push_back({id, 1, 0});
    }
  }
  return sensors;
}

}  // namespace

Saturation::Saturation(size_t sensors, double changing)
    : subscribed_(sensorsToSubscribe(sensors)),
      changing_(changing),
      client_(gliderDictionary,
              {"bench", 1, subscribed_.data(), static_cast<uint32_t>(subscribed_.size())}) {}

void Saturation::run(double seconds) {
  constexpr double kStep = 0.001;
  for (now_ = 0; now_ < kWarmUp + seconds; now_ += kStep) {
    line_.setNow(now_);
    if (tap_.written - read_ < kUnderWay) {
      flightCycle();
    }
    // Its own time runs faster: a cycle is complete a second after its last value.
    hookprog_.run(cycle_ + 1, {this, get, set}, tap_.stream());
    pollClient();
  }
  const double capacity = seconds * kFastBaud / 10;
  const auto count = static_cast<double>(subscribed_.size());
  fmt::print(
      "  {:3} sensors, {:4.0f} % changed: {:7.1f} ticks/s {:9.0f} readings/s   "
      "wire {:5.1f} %   values {:5.1f} %   with what says whose they are {:5.1f} %\n",
      subscribed_.size(), 100 * changing_, ticks_ / seconds, ticks_ * count / seconds,
      100 * static_cast<double>(tap_.written - written_before_) / capacity,
      100 * value_bytes_ / capacity,
      100 * (value_bytes_ + ticks_ * 2 * std::ceil(count / 8)) / capacity);
}

double Saturation::get(void* self, uint16_t id, bool* fresh) {
  *fresh = isScienceSensor(id) || static_cast<Saturation*>(self)->fresh_.erase(id) != 0;
  return static_cast<Saturation*>(self)->valueOf(id);
}

bool Saturation::changes(uint16_t id) const {
  return id % 16 < std::lround(16 * changing_) || id == GLIDER_M_PRESENT_SECS_INTO_MISSION ||
         id == GLIDER_M_CYCLE_NUMBER;
}

double Saturation::valueOf(uint16_t id) const {
  return changes(id) ? std::fmod(cycle_, sensorWidth(id) == 1 ? 100 : 1e6) : 1;
}

void Saturation::flightCycle() {
  cycle_ += 1;
  for (const Subscription& sensor : subscribed_) {
    fresh_.insert(sensor.id);
  }
  fresh_.insert(GLIDER_M_PRESENT_SECS_INTO_MISSION);
  fresh_.insert(GLIDER_M_CYCLE_NUMBER);
  hookprog_.run(cycle_, {this, get, set}, tap_.stream());
}

/// Nothing is written: the client gives no instruction.
void Saturation::set(void* /*self*/, uint16_t /*id*/, double /*value*/) {}

void Saturation::pollClient() {
  const GliderByteStream end = counted();
  for (ClientEvent event = ClientEvent::Handled; event != ClientEvent::Nothing;) {
    event = client_.poll(end, clockAt(now_));
    if (event == ClientEvent::Tick) {
      client_.done({}, end);
      countTick();
    }
  }
  if (now_ < kWarmUp) {
    written_before_ = tap_.written;
  }
}

void Saturation::countTick() {
  if (now_ < kWarmUp) {
    return;
  }
  ticks_ += 1;
  for (const Subscription& sensor : subscribed_) {
    value_bytes_ += changes(sensor.id) ? sensorWidth(sensor.id) : 0;
  }
}

GliderByteStream Saturation::counted() {
  return {this,
          [](void* self, uint8_t* bytes, uint32_t capacity) {
            auto& bench = *static_cast<Saturation*>(self);
            const GliderByteStream end = bench.line_.right();
            const int32_t got = end.read(end.self, bytes, capacity);
            bench.read_ += got > 0 ? static_cast<uint64_t>(got) : 0;
            return got;
          },
          [](void* self, const uint8_t* bytes, uint32_t count) {
            const GliderByteStream end = static_cast<Saturation*>(self)->line_.right();
            return end.write(end.self, bytes, count);
          }};
}

}  // namespace glider::bench
