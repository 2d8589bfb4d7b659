// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace glider::simulator {

/// The sensors that the simulated computers set or read, without those of instruments:
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

/// Under which number of its platform file a vehicle has the sensor `name`; hooks::kNoSensor if it
/// lacks it.
uint16_t numberOf(const platforms::Platform& platform, std::string_view name);

/// Under which number of its platform file a vehicle has each of them.
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
