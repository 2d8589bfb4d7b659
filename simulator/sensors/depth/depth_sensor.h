// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"
#include "simulator/sensors/sensor_settings.h"

namespace glider::simulator {

struct DepthSettings {
  double noise_m = 0.02;

  static constexpr ScenarioKey kKeys[] = {{"sensors", "depth_m"}};
  void read(ScenarioTables& tables);
};

/// The pressure transducer: 10 m of water are 1 bar, the vehicle's own conversion.
class DepthSensor {
 public:
  using Settings = DepthSettings;

  DepthSensor(uint64_t seed, const Settings& settings)
      : noise_(seed, "m_depth"), sd_(settings.noise_m) {}
  /// Gauge pressure in bar at true depth `depth_m`; may be slightly negative at the surface.
  double pressure(double depth_m) { return (depth_m + noise_.normal(sd_)) / kMetresPerBar; }

  static constexpr double kMetresPerBar = 10;

 private:
  Noise noise_;
  double sd_;
};

}  // namespace glider::simulator
