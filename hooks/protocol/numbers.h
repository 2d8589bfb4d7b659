// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

/// What is needed of a math library on board.
namespace glider::hooks {

/// False for NaN and the infinities.
inline bool isFinite(double value) {
  return value - value == 0;
}

/// The value that a 4-byte sensor would keep.
inline double asFloat32(double value) {
  return static_cast<double>(static_cast<float>(value));
}

}  // namespace glider::hooks
