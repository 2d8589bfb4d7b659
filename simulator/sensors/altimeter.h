// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"

#include <limits>

namespace glider::simulator {

/// The sonar that looks down: works between 2 and 100 m above the bottom and under the surface.
class Altimeter {
 public:
  Altimeter(uint64_t seed, double noise_m)
      : noise_(seed, static_cast<uint32_t>(NoiseStream::Altitude)), sd_(noise_m) {}
  /// Height above the bottom; NaN without an echo.
  double altitude(double depth_m, double water_depth_m) {
    const double read = water_depth_m - depth_m + noise_.normal(sd_);
    const bool echo = depth_m > kLeastDepth && read >= kLeast && read <= kMost;
    return echo ? read : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  static constexpr double kLeast = 2, kMost = 100, kLeastDepth = 2;
  Noise noise_;
  double sd_;
};

}  // namespace glider::simulator
