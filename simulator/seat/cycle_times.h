// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/scenario/cycle_settings.h"
#include "simulator/sensors/noise.h"

#include <cstdint>

namespace glider::simulator {

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
