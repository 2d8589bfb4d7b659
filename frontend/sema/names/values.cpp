// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/values.h"

#include <algorithm>

namespace glider::frontend {

std::span<const ValueText> valueTexts() {
  static constexpr ValueText kTexts[] = {
#define VALUE(name, type, what) {#name, type, what},
#include "frontend/sema/names/values.def"
#undef VALUE
  };
  return kTexts;
}

bool isValueName(std::string_view name) {
  return std::ranges::find(valueTexts(), name, &ValueText::name) != valueTexts().end();
}

std::optional<SensorState> findSensorState(const platforms::Platform& platform,
                                           std::string_view name) {
  for (const platforms::PlatformSensor& sensor : platform.sensors) {
    const auto found = std::ranges::find(sensor.states, name);
    if (found != sensor.states.end()) {
      return SensorState{&sensor, static_cast<double>(found - sensor.states.begin())};
    }
  }
  return std::nullopt;
}

const platforms::PlatformSensor* findTimestamp(const platforms::Platform& platform) {
  const auto found =
      std::ranges::find(platform.sensors, "timestamp", &platforms::PlatformSensor::unit);
  return found == platform.sensors.end() ? nullptr : &*found;
}

}  // namespace glider::frontend
