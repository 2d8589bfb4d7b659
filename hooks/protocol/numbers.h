// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

/// What is needed of a math library on board.
namespace glider::hooks {

/// False for NaN and the infinities.
inline bool isFinite(double value) {
  return value - value == 0;
}

inline double magnitude(double value) {
  return __builtin_fabs(value);
}

/// `value`, but no less than `least`; `least` for a NaN.
inline double atLeast(double value, double least) {
  return value > least ? value : least;
}

/// The value that a 4-byte sensor would keep.
inline double asFloat32(double value) {
  return static_cast<double>(static_cast<float>(value));
}

}  // namespace glider::hooks
