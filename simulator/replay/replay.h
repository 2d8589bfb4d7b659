// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/ports/sbc_port.h"

#include <cstdint>
#include <vector>

/// Flies a mission on given readings, without water or vehicle: the seat is the real one, and a
/// vehicle that accepts everything passes it the readings.
namespace glider::simulator {

/// A reading: the sensor's number in the platform file, and what the vehicle reports in its own
/// unit; NaN: a reading that failed.
struct ReplayReading {
  uint16_t sensor = 0;
  double raw = 0;
};

/// What the SBC receives at a mission time, s.
struct ReplayTick {
  double mission_time = 0;
  std::vector<ReplayReading> readings;
};

/// What the SBC did with a tick.
struct ReplayAnswer {
  bool answered = false;
  uint32_t state = 0;  ///< current after the tick
  uint32_t stack_depth = 0;
  bool finished = false;
};

/// Offers `sbc` control with the readings of the first of `ticks`, whose mission time is 0, and
/// feeds it the others. There is at least one. Ends after them, or earlier when it has ended its
/// mission or is gone: then with fewer answers. Empty if it never took control.
std::vector<ReplayAnswer> replay(const platforms::Platform& platform, SbcPort& sbc,
                                 const std::vector<ReplayTick>& ticks);

}  // namespace glider::simulator
