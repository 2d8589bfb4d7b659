// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"
#include "simulator/sensors/sensor_settings.h"

namespace glider::simulator {

/// The altimeter in a scenario, with the values of one that the scenario does not mention.
struct AltimeterSettings {
  double noise_m = 0.1;
  double range_m = 100;
  double dropout = 0;  ///< share of echoes that are lost
  bool given = false;  ///< [sensors.altimeter] is present

  static constexpr ScenarioKey kKeys[] = {{"sensors", "altitude_m"}, {"sensors", "altimeter"}};
  void read(ScenarioTables& tables);
};

/// The sonar that looks down: works from 2 m above the bottom up to its range, and under the
/// surface.
class Altimeter {
 public:
  using Settings = AltimeterSettings;

  Altimeter(uint64_t seed, const Settings& settings)
      : noise_(seed, "m_altitude"), dropout_(seed, "altimeter dropout"), settings_(settings) {}
  /// Height above the bottom; NaN without an echo.
  double altitude(double depth_m, double water_depth_m);

 private:
  Noise noise_, dropout_;
  Settings settings_;
};

}  // namespace glider::simulator
