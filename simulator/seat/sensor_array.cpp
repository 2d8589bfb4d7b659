// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/seat/sensor_array.h"

#include "hooks/protocol/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::simulator {

SensorArray::SensorArray(const platforms::Platform& platform)
    : numbers_(platform),
      values_(platform.sensors.size(), std::numeric_limits<double>::quiet_NaN()),
      fresh_(platform.sensors.size(), 0) {
  for (const auto& sensor : platform.sensors) {
    bytes_.push_back(sensor.bytes);
    science_.push_back(sensor.computer == platforms::Computer::Science ? 1 : 0);
  }
}

void SensorArray::set(uint16_t id, double value) {
  if (id >= values_.size()) {
    return;  // the vehicle does not have it
  }
  if (damage_ != nullptr) {
    const std::optional<double> reading = damage_->reading(id, value);
    if (!reading) {
      return;
    }
    value = *reading;
  }
  constexpr double kLowest = -128, kHighest = 127;
  if (bytes_[id] == 4) {
    value = hookAsFloat32(value);
  } else if (bytes_[id] == 1 && !std::isnan(value)) {
    value = std::clamp(std::nearbyint(value), kLowest, kHighest);
  }
  values_[id] = value;
  fresh_[id] = 1;
}

void SensorArray::clear() {
  std::ranges::fill(values_, std::numeric_limits<double>::quiet_NaN());
  beginCycle();
}

void SensorArray::beginCycle() {
  std::ranges::fill(fresh_, uint8_t{0});
}

}  // namespace glider::simulator
