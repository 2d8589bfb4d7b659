// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/worlds/naps.h"

namespace glider::ir {

void allowForNaps(const Mission& mission, platforms::EnvironmentModel& world) {
  if (mission.nap_s) {
    world.command_delay_s += kNapLag_s;
  }
}

}  // namespace glider::ir
