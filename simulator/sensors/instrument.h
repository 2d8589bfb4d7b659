// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/ocean/ocean.h"

#include <span>
#include <string_view>

namespace glider::simulator {

/// Where and when an instrument samples the water: m down, m east and north of the world's origin.
struct Sampling {
  double time_s = 0;
  double depth_m = 0, x = 0, y = 0;
  const Ocean& ocean;
};

/// A sensor of the vehicle that an instrument sets, by the name in the platform file.
struct InstrumentSensor {
  std::string_view name;
  const char* column_unit = nullptr;  ///< of its column in the trace; null: no column
};

/// The program of the science computer that runs an instrument: its number in sensor_type of the
/// behaviour sample, and the middle of its switch, c_profile_on.
struct Proglet {
  int sensor_type = 0;
  std::string_view name;
};

/// An instrument of the science bay. All code of the simulator for one kind is in one folder, and
/// the kind is a row of sensor_list.h. In addition to these functions its class has Settings
/// (sensor_settings.h) and a constructor that takes the seed of the flight and the settings.
class Instrument {
 public:
  virtual ~Instrument() = default;
  /// The sensors that it sets; the same for each instrument of the kind.
  [[nodiscard]] virtual std::span<const InstrumentSensor> sensors() const = 0;
  [[nodiscard]] virtual Proglet proglet() const = 0;
  /// The setting in a scenario file that puts the instrument on board, for messages to the pilot;
  /// "": every vehicle has the instrument.
  [[nodiscard]] virtual std::string_view setting() const { return ""; }
  /// Whether the scenario has that setting.
  [[nodiscard]] virtual bool carried() const { return true; }
  /// Called once a second: writes a reading for each of sensors() to `readings`, in the same order.
  /// A sensor whose entry stays NaN is not set in this second.
  virtual void sample(const Sampling& at, std::span<double> readings) = 0;
};

}  // namespace glider::simulator
