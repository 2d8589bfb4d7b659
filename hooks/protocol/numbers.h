// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The few functions of a math library that are needed on board.
namespace glider::hooks {

/// False for NaN and the infinities.
inline bool isFinite(double value) {
  return value - value == 0;
}

inline double magnitude(double value) {
  return __builtin_fabs(value);
}

/// The greater and the lesser of two; the bound where `value` is NaN.
inline double atLeast(double value, double least) {
  return value > least ? value : least;
}
inline double atMost(double value, double most) {
  return value < most ? value : most;
}

/// NaN where `value` is NaN.
inline double between(double value, double lowest, double highest) {
  return value < lowest ? lowest : value > highest ? highest : value;
}

/// The value that a 4-byte sensor would keep.
inline double asFloat32(double value) {
  return static_cast<double>(static_cast<float>(value));
}

/// Whether `value` is a whole number from `lowest` to `highest`, which is then in `whole`.
inline bool isWhole(double value, uint32_t lowest, uint32_t highest, uint32_t* whole) {
  if (!(value >= lowest && value <= highest)) {
    return false;
  }
  *whole = static_cast<uint32_t>(value);
  return static_cast<double>(*whole) == value;
}

}  // namespace glider::hooks
