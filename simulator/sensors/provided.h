// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace glider::simulator {

/// The sensors that the simulated computers set or read, except those of instruments:
/// Sensor::m_depth.
enum class Sensor : uint16_t {
#define SENSOR(name, need) name,
#include "simulator/sensors/provided.def"
#undef SENSOR
};

/// Whether the simulated computers or instruments provide the sensor that the vehicle calls `name`.
bool isProvided(std::string_view name);
/// The first sensor that the simulated flight controller needs and the vehicle lacks; empty: none.
std::string_view missingSensor(const platforms::Platform& platform);

/// The number of the sensor `name` in a vehicle's platform file; hooks::kNoSensor if the vehicle
/// lacks it.
uint16_t numberOf(const platforms::Platform& platform, std::string_view name);

/// The number of each of them in a vehicle's platform file.
class SensorNumbers {
 public:
  explicit SensorNumbers(const platforms::Platform& platform);
  /// hooks::kNoSensor if the vehicle lacks it.
  [[nodiscard]] uint16_t operator[](Sensor sensor) const {
    return numbers_[static_cast<size_t>(sensor)];
  }

 private:
  static constexpr size_t kCount = 0
#define SENSOR(name, need) +1
#include "simulator/sensors/provided.def"
#undef SENSOR
      ;
  std::array<uint16_t, kCount> numbers_{};
};

}  // namespace glider::simulator
