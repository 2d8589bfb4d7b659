// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"
#include "simulator/sensors/settings.h"

#include <algorithm>
#include <limits>

namespace glider::simulator {

/// The CTD of the science bay, read once a second.
class Ctd {
 public:
  Ctd(uint64_t seed, const SensorSettings& settings)
      : temperature_noise_(seed, static_cast<uint32_t>(NoiseStream::Temperature)),
        dropout_(seed, static_cast<uint32_t>(NoiseStream::CtdDropout)),
        settings_(settings) {}

  /// degC; NaN when the reading fails.
  double temperature(double truth, double now_s) {
    const double noise = temperature_noise_.normal(settings_.temperature_degC);
    const bool lost = dropout_.uniform() < settings_.ctd_dropout;
    const bool stale =
        std::ranges::any_of(settings_.stale_water, [&](const StaleWater& stale_water) {
          return now_s >= stale_water.from_s && now_s < stale_water.to_s;
        });
    if (!stale || std::isnan(in_duct_)) {
      in_duct_ = truth;
    }
    return lost ? std::numeric_limits<double>::quiet_NaN() : in_duct_ + noise;
  }

 private:
  Noise temperature_noise_, dropout_;
  SensorSettings settings_;
  double in_duct_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace glider::simulator
