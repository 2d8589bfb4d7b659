// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"

namespace glider::simulator {

/// The pressure transducer: 10 m of water are 1 bar, as the vehicle reckons.
class DepthSensor {
 public:
  DepthSensor(uint64_t seed, double noise_m)
      : noise_(seed, static_cast<uint32_t>(NoiseStream::Depth)), sd_(noise_m) {}
  /// Gauge pressure in bar at true depth `depth_m`; may be slightly negative at the surface.
  double pressure(double depth_m) { return (depth_m + noise_.normal(sd_)) / kMetresPerBar; }

  static constexpr double kMetresPerBar = 10;

 private:
  Noise noise_;
  double sd_;
};

}  // namespace glider::simulator
