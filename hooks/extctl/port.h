// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/sensor_list.h"
#include "hooks/protocol/sensors.h"

#include <stdint.h>

/// Which sensor has which index on the port: what extctl.ini says to the vehicle, and the program
/// on the SBC knows without it.
namespace glider::hooks::extctl {

/// The sensors that do not depend on the mission, by their indices.
enum class PortSensor : uint8_t {
#define PARAMETER(name, sensor, unit) name,
#define WRITTEN(name, sensor, unit) name,
#define MARK(name, sensor, unit) name,
#include "hooks/extctl/port.def"
  Count
};
inline constexpr uint32_t kFixedSensors = static_cast<uint32_t>(PortSensor::Count);

/// Those that the SBC writes come first.
inline constexpr uint32_t kWrittenSensors = static_cast<uint32_t>(PortSensor::Program);

/// Before the SBC has written any, the yo of the mission file is one just below the surface, m.
inline constexpr double kFirstDiveDepth = 3;
inline constexpr double kFirstClimbDepth = 1;

/// How long a value may need from the SBC to the behaviours, s: two sentences lost, and 8 s
/// between the vehicle's computers. What must not overtake it waits as long.
inline constexpr double kSettleSecs = 20;

/// Vehicles take this many, newer ones twice as many.
inline constexpr uint32_t kUsualSensors = 32;
inline constexpr uint32_t kMostSensors = 64;

/// The readings on the port, by index from kFixedSensors on: those that the program needs itself,
/// then those of the mission, each once, and the vehicle's clock last, so that its report ends that
/// of a cycle.
class Port {
 public:
  /// `sensors`: the mission's, and others that the program needs. The dictionary is not kept.
  Port(const GliderDictionary& dictionary, const Subscription* sensors, uint32_t count);

  /// All sensors with an index, the fixed ones too. More than kMostSensors: they have none.
  [[nodiscard]] uint32_t count() const { return kFixedSensors + count_; }
  [[nodiscard]] bool fits() const { return fits_; }
  /// The number in the platform file of the sensor with this index; kNoSensor for a fixed one.
  [[nodiscard]] uint16_t sensorAt(uint32_t index) const {
    return index >= kFixedSensors && index < count() ? sensors_[index - kFixedSensors] : kNoSensor;
  }
  /// The index of a sensor by its number; count() if it has none.
  [[nodiscard]] uint32_t indexOf(uint16_t sensor) const;

 private:
  void add(uint16_t sensor);

  uint16_t sensors_[kMostSensors - kFixedSensors];
  uint32_t count_ = 0;
  bool fits_ = true;
};

}  // namespace glider::hooks::extctl
