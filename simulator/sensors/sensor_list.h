// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/altimeter/altimeter.h"
#include "simulator/sensors/attitude/attitude_sensor.h"
#include "simulator/sensors/ctd/ctd.h"
#include "simulator/sensors/depth/depth_sensor.h"
#include "simulator/sensors/fluorometer/fluorometer.h"
#include "simulator/sensors/gps/gps.h"
#include "simulator/sensors/optode/optode.h"

#include <memory>
#include <vector>

/// The simulated sensors: ROW(member of SensorSettings, class).
/// The sensors of the flight controller, which reads each of them differently.
#define GLIDER_FLIGHT_SENSORS(ROW) \
  ROW(depth, DepthSensor)          \
  ROW(attitude, AttitudeSensor)    \
  ROW(altimeter, Altimeter)        \
  ROW(gps, Gps)
/// The sensors of the science computer. Their columns in the trace are in this order.
#define GLIDER_INSTRUMENTS(ROW) \
  ROW(ctd, Ctd)                 \
  ROW(fluorometer, Fluorometer) \
  ROW(optode, Optode)

namespace glider::simulator {

/// What a scenario specifies about the sensors.
struct SensorSettings {
#define ROW(name, Class) Class::Settings name = {};
  GLIDER_FLIGHT_SENSORS(ROW)
  GLIDER_INSTRUMENTS(ROW)
#undef ROW

  /// Reads the settings of a scenario file.
  void read(ScenarioTables& tables);
};

/// The keys that sensors read in [table] of a scenario.
std::vector<std::string_view> sensorKeys(std::string_view table);

/// The proglets of all instruments of the list.
const std::vector<Proglet>& simulatedProglets();

/// All instruments of the list, on board or not, with the scenario's settings.
std::vector<std::unique_ptr<Instrument>> makeInstruments(uint64_t seed,
                                                         const SensorSettings& settings);

}  // namespace glider::simulator
