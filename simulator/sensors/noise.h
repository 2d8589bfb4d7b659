// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <Random123/philox.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace glider::simulator {

/// The random numbers of one sensor: Philox, counter-based (Salmon et al. 2011,
/// doi 10.1145/2063384.2063405), so that sensors do not disturb each other and a seed gives the
/// same flight everywhere.
class Noise {
 public:
  Noise(uint64_t seed, uint32_t stream)
      : key_{{static_cast<uint32_t>(seed), static_cast<uint32_t>(seed >> 32U)}}, stream_(stream) {}
  /// `source`: a unique name, such as the sensor's. Names do not affect each other's random
  /// numbers.
  Noise(uint64_t seed, std::string_view source);

  /// Gaussian with standard deviation `sd` (Box-Muller).
  double normal(double sd) {
    const Draw draw = next();
    return sd == 0
               ? 0
               : sd * std::sqrt(-2 * std::log(draw.a)) * std::cos(2 * std::numbers::pi * draw.b);
  }
  /// Uniform in (0, 1).
  double uniform() { return next().a; }

 private:
  struct Draw {
    double a, b;  ///< both in (0, 1)
  };
  Draw next() {
    const r123::Philox4x32::ctr_type counter{
        {static_cast<uint32_t>(count_), static_cast<uint32_t>(count_ >> 32U),
         static_cast<uint32_t>(stream_), static_cast<uint32_t>(stream_ >> 32U)}};
    ++count_;
    const auto bits = r123::Philox4x32()(counter, key_);
    return {unit(bits[0], bits[1]), unit(bits[2], bits[3])};
  }
  static double unit(uint32_t high, uint32_t low) {
    const uint64_t all = (static_cast<uint64_t>(high) << 32U) | low;
    return (static_cast<double>(all >> 12U) + 0.5) * 0x1p-52;
  }

  r123::Philox4x32::key_type key_;
  uint64_t stream_;  ///< at most 32 bits: a number; more: the hash of a name
  uint64_t count_ = 0;
};

/// The seed of all random numbers of vehicle `number` (from 0) of a world. That of the first is the
/// world's own; the others are independent of it and of each other (SplitMix64's output function,
/// Steele et al. 2014, doi 10.1145/2660193.2660195).
uint64_t seedOfVehicle(uint64_t world_seed, uint32_t number);

/// The numbered streams that do not belong to a sensor. Streams of sensors have names; the numbers
/// below LineDamage belong to the first sensors (noise.cpp).
enum class NoiseStream : uint32_t {
  LineDamage = 12,  ///< and three more, one per LineWay
  Campaign = LineDamage + 4,
  SensorJumps,
  CardDamage,
  ScienceSensorJumps,
};

}  // namespace glider::simulator
