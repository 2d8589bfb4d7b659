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

/// Climbs on which the CTD's duct is not flushed, as on the lost climb of the paper's Figure 6.
struct StaleClimbs {
  bool on = false;
  double frozen_s = 120;  ///< from the turn on, the duct keeps its water for so long
  double flush_s = 20;    ///< time constant with which the water is then renewed; 0: at once
  double after_s = 0;     ///< climbs that begin earlier are not meant
  double count = 0;       ///< how many climbs; 0: all
};

struct CtdSettings {
  double noise_degC = 0.002;
  double dropout = 0;          ///< share of readings that fail
  double repeat_fraction = 0;  ///< share of readings that are the one before once more
  double late_s = 0;           ///< age of a reading when it is given
  /// The sensor sees water from so far above or below the vehicle (standard deviation, m).
  double non_monotonic_m = 0;
  double conductivity = 4;  ///< S/m, the same everywhere, as in the vehicle's own simulator
  std::vector<StaleWater> stale_water = {};
  StaleClimbs stale_climbs = {};
};

struct AltimeterSettings {
  double noise_m = 0.1;
  double range_m = 100;
  double dropout = 0;  ///< share of echoes that are lost
};

/// Standard deviations of the sensors' noise, and their failures.
struct SensorSettings {
  double depth_m = 0.02;
  double pitch_rad = 0.009;
  double heading_rad = 0.01;
  double gps_m = 3;
  double chlorophyll_ugpl = 0.02;
  double oxygen_uM = 0.5;
  AltimeterSettings altimeter;
  CtdSettings ctd;
};

}  // namespace glider::simulator
