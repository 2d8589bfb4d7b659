// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/sensors/noise.h"

#include <cstdint>

namespace glider::simulator {

/// How long the control cycles take. Those of real vehicles are neither of the nominal length nor
/// equal: 4.4 s on average on gliders of 2014, and some of 15 s while a device is slow.
struct CycleSettings {
  double mean_s = 0;    ///< of the usual ones; 0: as the platform file says
  double spread_s = 0;  ///< their standard deviation
  double long_share = 0;
  double long_s = 15;
};

/// Draws the lengths of the cycles, in steps of the vehicle model.
class CycleTimes {
 public:
  CycleTimes(const CycleSettings& settings, double nominal_s, double step_s, uint64_t seed)
      : settings_(settings), nominal_s_(nominal_s), step_s_(step_s), noise_(seed, "cycles") {}
  /// Of the next cycle.
  int64_t steps();

 private:
  CycleSettings settings_;
  double nominal_s_, step_s_;
  Noise noise_;
};

}  // namespace glider::simulator
