// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <random>
#include <span>

namespace glider::random_missions {

/// The numbers of one seed, the same with every standard library.
class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, n); n is not 0.
  uint32_t below(uint64_t n) { return static_cast<uint32_t>(engine_() % n); }
  /// Uniform in [lowest, highest].
  uint32_t between(uint32_t lowest, uint32_t highest) {
    return lowest + below(uint64_t{highest} - lowest + 1);
  }
  bool chance(double probability) { return unit() < probability; }
  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double lowest, double highest) { return lowest + (highest - lowest) * unit(); }
  template <typename Range>
  const auto& pick(const Range& range) {
    return range[below(std::size(range))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace glider::random_missions
