// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

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

}  // namespace glider::hooks
