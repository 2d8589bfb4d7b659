// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"
#include "simulator/sensors/sensor_settings.h"

#include <optional>

namespace glider::simulator {

struct GpsSettings {
  double noise_m = 3;

  static constexpr ScenarioKey kKeys[] = {{"sensors", "gps_m"}};
  void read(ScenarioTables& tables);
};

/// The receiver in the tail: gets a fix after it has been at the surface for a while.
class Gps {
 public:
  using Settings = GpsSettings;
  struct Fix {
    double x = 0, y = 0;  ///< m east and north of the world's origin
  };
  Gps(uint64_t seed, const Settings& settings) : noise_(seed, "gps"), sd_(settings.noise_m) {}

  /// The fix at `now_s`, if there is one. Call once a cycle.
  std::optional<Fix> fix(double x, double y, double depth_m, double now_s);

  /// The variation of a fix, rad: magnetic minus true heading, so it is west positive. The receiver
  /// takes it from a table, to a tenth of a degree.
  static double variation(double declination_rad);

 private:
  static constexpr double kFirstFix = 20;  // s
  Noise noise_;
  double sd_;
  double surfaced_s_ = -kFirstFix;  ///< the mission starts with a fix
};

}  // namespace glider::simulator
