// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>

namespace glider::simulator {

/// Degrees as the vehicle writes them: -73.83009 becomes -7349.8054.
inline double toDdmm(double degrees) {
  const double whole = std::trunc(degrees);
  return whole * 100 + (degrees - whole) * 60;
}

inline double fromDdmm(double ddmm) {
  const double whole = std::trunc(ddmm / 100);
  return whole + (ddmm - whole * 100) / 60;
}

}  // namespace glider::simulator
