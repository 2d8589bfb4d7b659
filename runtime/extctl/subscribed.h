// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/port.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/port_mission.h"

namespace glider::runtime::extctl {

/// The port of a compiled mission: where the vehicle is, the sensors that the mission reads, and
/// the depth, which decides whether it may begin.
inline hooks::extctl::Port portOf(const GliderMission& mission, const GliderPortMission& port) {
  hooks::Subscription sensors[hooks::kMostSubscriptions + 3];
  uint32_t count = 0;
  sensors[count++].id = static_cast<uint16_t>(port.latitude);
  sensors[count++].id = static_cast<uint16_t>(port.longitude);
  for (uint32_t i = 0; i < mission.sensor_count && count < hooks::kMostSubscriptions + 2; ++i) {
    if (mission.sensors[i].poll == nullptr) {
      sensors[count++].id = static_cast<uint16_t>(mission.sensors[i].id);
    }
  }
  sensors[count++].id = hooks::sensorOf(*mission.dictionary, kGliderRoleDepth);
  return {*mission.dictionary, sensors, count};
}

}  // namespace glider::runtime::extctl
