// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>
#include <string.h>

/// Doubles by their bit pattern, which no board's floating-point unit can alter.
namespace glider::runtime {

inline uint64_t bitsOf(double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline double doubleOf(uint64_t bits) {
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

inline constexpr uint64_t kSignBit = 0x8000000000000000U;
inline constexpr double kTwoPi = 6.283185307179586;

/// The one NaN that missions see.
inline double unknown() {
  return doubleOf(0x7FF8000000000000U);
}

inline bool isFinite(double value) {
  constexpr uint64_t kExponent = 0x7FF0000000000000U;
  return (bitsOf(value) & kExponent) != kExponent;
}

inline bool isKnown(double value) {
  constexpr uint64_t kInfinity = 0x7FF0000000000000U;
  return (bitsOf(value) & ~kSignBit) <= kInfinity;
}

inline double magnitude(double value) {
  return doubleOf(bitsOf(value) & ~kSignBit);
}
inline double negated(double value) {
  return doubleOf(bitsOf(value) ^ kSignBit);
}

/// The remainder of `size` divided by `of`: identical to fmod. `size` is not negative, `of` is at
/// least 1; NaN if an argument is not finite.
double restOf(double size, double of);

}  // namespace glider::runtime
