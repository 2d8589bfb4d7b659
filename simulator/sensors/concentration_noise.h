// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"

#include <algorithm>

namespace glider::simulator {

/// The noise of an instrument that measures a concentration in the water.
class ConcentrationNoise {
 public:
  /// `sensor`: the sensor with this noise; `sd`: standard deviation in the sensor's unit.
  ConcentrationNoise(uint64_t seed, std::string_view sensor, double sd)
      : noise_(seed, sensor), sd_(sd) {}
  /// The reading of `truth`, never negative.
  double read(double truth) { return std::max(0.0, truth + noise_.normal(sd_)); }

 private:
  Noise noise_;
  double sd_;
};

}  // namespace glider::simulator
