// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"

namespace glider::simulator {

/// The compass and tilt sensor.
class AttitudeSensor {
 public:
  AttitudeSensor(uint64_t seed, double pitch_noise_rad, double heading_noise_rad)
      : pitch_noise_(seed, static_cast<uint32_t>(NoiseStream::Pitch)),
        heading_noise_(seed, static_cast<uint32_t>(NoiseStream::Heading)),
        pitch_sd_(pitch_noise_rad),
        heading_sd_(heading_noise_rad) {}

  double pitch(double truth) { return truth + pitch_noise_.normal(pitch_sd_); }
  /// Of a magnetic heading; in [0, 2 pi).
  double heading(double truth) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const double read = truth + heading_noise_.normal(heading_sd_);
    return read - kTurn * std::floor(read / kTurn);
  }

 private:
  Noise pitch_noise_, heading_noise_;
  double pitch_sd_, heading_sd_;
};

}  // namespace glider::simulator
