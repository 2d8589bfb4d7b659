// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/nap_tick.h"

namespace glider::runtime {

bool takeKeptFrame(MissionClock& clock, const hooks::VehicleTick& tick, double sbc_time,
                   double& mission_time) {
  if (tick.kept) {
    mission_time = clock.atKeptFrame(tick.vehicle_time_s, tick.cycle, sbc_time);
  }
  return tick.kept;
}

}  // namespace glider::runtime
