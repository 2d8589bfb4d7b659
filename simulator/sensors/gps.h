// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace glider::simulator {

/// The receiver in the tail: has a fix once it has been at the surface for a while.
class Gps {
 public:
  struct Fix {
    double x = 0, y = 0;  ///< m east and north of the start
  };
  Gps(uint64_t seed, double noise_m)
      : noise_(seed, static_cast<uint32_t>(NoiseStream::Gps)), sd_(noise_m) {}

  /// The fix at `now_s`, if there is one. Call once a cycle.
  std::optional<Fix> fix(double x, double y, double depth_m, double now_s) {
    if (depth_m > kAntennaDepth) {
      surfaced_s_ = now_s;
      return std::nullopt;
    }
    if (now_s - surfaced_s_ < kFirstFix) {
      return std::nullopt;
    }
    const double east = noise_.normal(sd_);
    return Fix{x + east, y + noise_.normal(sd_)};
  }

  /// What a fix says of magnetic north, rad: magnetic headings exceed true ones by it, so it is
  /// west positive. The receiver has it from a table, to a tenth of a degree.
  static double variation(double declination_rad) {
    constexpr double kTenth = std::numbers::pi / 1800;
    return -std::round(declination_rad / kTenth) * kTenth;
  }

 private:
  static constexpr double kAntennaDepth = 0.3;  // m
  static constexpr double kFirstFix = 20;       // s
  Noise noise_;
  double sd_;
  double surfaced_s_ = -kFirstFix;  ///< the mission starts with a fix
};

}  // namespace glider::simulator
