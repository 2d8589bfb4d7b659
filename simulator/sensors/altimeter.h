// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"
#include "simulator/sensors/settings.h"

#include <limits>

namespace glider::simulator {

/// The sonar that looks down: works from 2 m above the bottom up to its range, and under the
/// surface.
class Altimeter {
 public:
  Altimeter(uint64_t seed, const AltimeterSettings& settings)
      : noise_(seed, static_cast<uint32_t>(NoiseStream::Altitude)),
        dropout_(seed, static_cast<uint32_t>(NoiseStream::AltimeterDropout)),
        settings_(settings) {}
  /// Height above the bottom; NaN without an echo.
  double altitude(double depth_m, double water_depth_m) {
    const double read = water_depth_m - depth_m + noise_.normal(settings_.noise_m);
    const bool lost = dropout_.uniform() < settings_.dropout;
    const bool echo = !lost && depth_m > kLeastDepth && read >= kLeast && read <= settings_.range_m;
    return echo ? read : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  static constexpr double kLeast = 2, kLeastDepth = 2;
  Noise noise_, dropout_;
  AltimeterSettings settings_;
};

}  // namespace glider::simulator
