// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/provided.h"

#include "hooks/protocol/sensors.h"
#include "simulator/sensors/sensor_list.h"

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
  const auto sets = [name](const std::unique_ptr<Instrument>& instrument) {
    return std::ranges::any_of(instrument->sensors(), [name](const InstrumentSensor& sensor) {
      return sensor.name == name;
    });
  };
  return std::ranges::find(kProvided, name, &Provided::name) != std::end(kProvided) ||
         std::ranges::any_of(makeInstruments(0, {}), sets);
}

std::string_view missingSensor(const platforms::Platform& platform) {
  for (const Provided& sensor : kProvided) {
    if (sensor.need == Need::Required && numberOf(platform, sensor.name) == hooks::kNoSensor) {
      return sensor.name;
    }
  }
  return "";
}

uint16_t numberOf(const platforms::Platform& platform, std::string_view name) {
  const auto found = std::ranges::find(platform.sensors, name, &platforms::PlatformSensor::name);
  return found == platform.sensors.end() ? hooks::kNoSensor : found->id;
}

SensorNumbers::SensorNumbers(const platforms::Platform& platform) {
  static_assert(std::size(kProvided) == kCount);
  for (size_t i = 0; i < kCount; ++i) {
    numbers_[i] = numberOf(platform, kProvided[i].name);
  }
}

}  // namespace glider::simulator
