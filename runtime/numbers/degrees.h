// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/behaviour.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {

/// Converts ddmm.mmmm, as the vehicle has positions, to degrees; keeps the sign; unknown from 60
/// minutes on.
inline double degreesOfPosition(double ddmm) {
  const double size = magnitude(ddmm);
  const double minutes = restOf(size, 100.0);
  const double degrees = (size - minutes) / 100.0;  // exact: a multiple of 100
  if (!(minutes < 60.0)) {
    return unknown();
  }
  return gliderSettle(doubleOf(bitsOf(degrees + minutes / 60.0) | (bitsOf(ddmm) & kSignBit)));
}

}  // namespace glider::runtime
