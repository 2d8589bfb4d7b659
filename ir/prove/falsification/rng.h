// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace glider::ir::prove {

/// Random numbers from a seed, the same with every standard library.
class Rng {
 public:
  explicit Rng(uint64_t seed) : engine_(seed) {}

  uint32_t below(uint64_t n) { return static_cast<uint32_t>(engine_() % n); }
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double within(double lowest, double highest) { return lowest + (highest - lowest) * unit(); }
  bool chance(double probability) { return unit() < probability; }
  /// A time, s, from a cycle to a day: every order of magnitude is equally likely.
  double lasting() { return 4 * std::pow(10, 4.3 * unit()); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace glider::ir::prove
