// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cmath>

namespace glider::ir::prove {

/// Rounds a mission time (s) to one that the vehicle's clock, a float of 4 bytes, can represent for
/// three days. A trace with other times cannot be replayed.
inline double onVehicleClock(double mission_time) {
  constexpr double kSteps = 64;
  return std::round(mission_time * kSteps) / kSteps;
}

}  // namespace glider::ir::prove
