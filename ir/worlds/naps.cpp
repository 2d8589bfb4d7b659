// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/worlds/naps.h"

namespace glider::ir {

double napAhead_m(const platforms::Platform& platform) {
  const platforms::EnvironmentModel& world = platform.world;
  return platform.envelope.vertical_rate_m_s * (world.tick_gap_s + kNapLag_s) +
         2 * world.depth_error_m;
}

void allowForNaps(const Mission& mission, platforms::EnvironmentModel& world) {
  if (mission.nap_s) {
    world.command_delay_s += kNapLag_s;
  }
}

}  // namespace glider::ir
