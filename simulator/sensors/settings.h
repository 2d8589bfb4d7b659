// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

namespace glider::simulator {

/// A time in which the water in the CTD's duct does not change: the sensor goes on giving its last
/// temperature.
struct StaleWater {
  double from_s = 0;
  double to_s = 0;
};

/// Standard deviations of the sensors' noise, and the CTD's failures.
struct SensorSettings {
  double depth_m = 0.02;
  double pitch_rad = 0.009;
  double heading_rad = 0.01;
  double altitude_m = 0.1;
  double gps_m = 3;
  double temperature_degC = 0.002;
  double ctd_dropout = 0;   ///< share of readings that are NaN
  double conductivity = 4;  ///< S/m, the same everywhere, as in the vehicle's own simulator
  std::vector<StaleWater> stale_water;
};

}  // namespace glider::simulator
