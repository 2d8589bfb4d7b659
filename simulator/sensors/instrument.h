// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/ocean/ocean.h"

#include <span>
#include <string_view>

namespace glider::simulator {

/// Where and when an instrument samples the water: m down, m east and north of the start.
struct Sampling {
  double time_s = 0;
  double depth_m = 0, x = 0, y = 0;
  const Ocean& ocean;
};

/// A sensor of the vehicle that an instrument sets, by the name in the platform file.
struct InstrumentSensor {
  std::string_view name;
  const char* column_unit = nullptr;  ///< of its column in the trace; null: it has none
};

/// An instrument of the science bay. All that the simulator knows of one kind lies in one folder,
/// and the kind is a row of sensor_list.h. Beside these functions its class has Settings
/// (sensor_settings.h) and a constructor that takes the seed of the flight and the settings.
class Instrument {
 public:
  virtual ~Instrument() = default;
  /// The sensors that it sets; the same for each instrument of the kind.
  [[nodiscard]] virtual std::span<const InstrumentSensor> sensors() const = 0;
  /// What in a scenario's file puts the instrument on board, for the pilot; "": each vehicle has
  /// it.
  [[nodiscard]] virtual std::string_view setting() const { return ""; }
  /// Whether the scenario has that setting.
  [[nodiscard]] virtual bool carried() const { return true; }
  /// Once a second: puts a reading for each of sensors() into `readings`, in the same order. What
  /// is left as it is, NaN, is not set in this second.
  virtual void sample(const Sampling& at, std::span<double> readings) = 0;
};

}  // namespace glider::simulator
