// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/provided.h"

#include "hooks/protocol/sensors.h"

#include <algorithm>

namespace glider::simulator {
namespace {

enum class Need : uint8_t { Optional, Required };

struct Provided {
  std::string_view name;
  Need need;
};

constexpr Provided kProvided[] = {
#define SENSOR(name, need) {#name, Need::need},
#include "simulator/sensors/provided.def"
#undef SENSOR
};

}  // namespace

bool isProvided(std::string_view name) {
  return std::ranges::find(kProvided, name, &Provided::name) != std::end(kProvided);
}

std::string_view missingSensor(const platforms::Platform& platform) {
  for (const Provided& sensor : kProvided) {
    if (sensor.need == Need::Required && platform.find(sensor.name) == nullptr) {
      return sensor.name;
    }
  }
  return "";
}

SensorNumbers::SensorNumbers(const platforms::Platform& platform) {
  static_assert(std::size(kProvided) == kCount);
  for (size_t i = 0; i < kCount; ++i) {
    const auto found =
        std::ranges::find(platform.sensors, kProvided[i].name, &platforms::PlatformSensor::name);
    numbers_[i] = found == platform.sensors.end() ? hooks::kNoSensor : found->id;
  }
}

}  // namespace glider::simulator
