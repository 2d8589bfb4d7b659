// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// In place of sleep.cpp and naps/kept_frame.cpp in the program of a mission without `nap at most`.

#include "runtime/board/line.h"
#include "runtime/core/nap_tick.h"

namespace glider::runtime {

/// Not reached: its program never orders a sleep.
void sleepBoard(const Options& /*options*/) {}

/// A vehicle keeps no frames for a program that does not sleep.
bool takeKeptFrame(MissionClock& /*clock*/, const hooks::VehicleTick& /*tick*/, double /*sbc_time*/,
                   double& /*mission_time*/) {
  return false;
}

}  // namespace glider::runtime
