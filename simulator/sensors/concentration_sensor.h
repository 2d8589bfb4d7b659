// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"

#include <algorithm>

namespace glider::simulator {

/// A sensor of the science bay that reads how much of something is in the water: the fluorometer,
/// the oxygen optode.
class ConcentrationSensor {
 public:
  /// `noise`: standard deviation in the sensor's unit.
  ConcentrationSensor(uint64_t seed, NoiseStream stream, double noise)
      : noise_(seed, static_cast<uint32_t>(stream)), sd_(noise) {}
  /// Never negative.
  double read(double truth) { return std::max(0.0, truth + noise_.normal(sd_)); }

 private:
  Noise noise_;
  double sd_;
};

}  // namespace glider::simulator
