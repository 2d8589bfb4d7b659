// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/faults/sensor_damage.h"
#include "simulator/sensors/provided.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace glider::simulator {

/// The flight controller's data memory: every sensor of the platform by its number, rounded to its
/// width.
class SensorArray {
 public:
  explicit SensorArray(const platforms::Platform& platform);

  /// Stores `value`, rounded to the sensor's width, and marks it fresh. NaN is stored as never set.
  void set(uint16_t id, double value);
  void set(Sensor sensor, double value) { set(numbers_[sensor], value); }
  /// NaN when never set, and if the vehicle lacks the sensor.
  [[nodiscard]] double get(uint16_t id) const {
    return id < values_.size() ? values_[id] : std::numeric_limits<double>::quiet_NaN();
  }
  [[nodiscard]] double get(Sensor sensor) const { return get(numbers_[sensor]); }
  /// Whether the vehicle has the sensor.
  [[nodiscard]] bool has(Sensor sensor) const { return numbers_[sensor] < values_.size(); }
  /// Set since beginCycle.
  [[nodiscard]] bool fresh(uint16_t id) const { return id < fresh_.size() && fresh_[id] != 0; }
  [[nodiscard]] bool fresh(Sensor sensor) const { return fresh(numbers_[sensor]); }
  void beginCycle();
  /// Marks all sensors as never set.
  void clear();
  /// From now on sensors report what `damage` makes of them; null: the truth.
  void damageBy(SensorDamage* damage) { damage_ = damage; }
  [[nodiscard]] uint16_t size() const { return static_cast<uint16_t>(values_.size()); }
  /// True for a sensor of the science computer.
  [[nodiscard]] bool ofScience(uint16_t id) const { return science_[id] != 0; }

 private:
  SensorNumbers numbers_;
  SensorDamage* damage_ = nullptr;
  std::vector<double> values_;
  std::vector<uint8_t> bytes_, fresh_, science_;
};

}  // namespace glider::simulator
