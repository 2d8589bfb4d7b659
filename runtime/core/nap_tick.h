// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/core/link_log.h"
#include "runtime/core/mission_clock.h"

#include <stdint.h>

/// Lets the SBC sleep between ticks whose effect is known before, if its line `nap at most` and the
/// vehicle allow it. What does that is reached only by a pointer of the mission (GliderNaps), so
/// that other missions do not link it; or board/no_naps.cpp takes its place in their programs.
namespace glider::runtime {

/// What is kept from tick to tick.
struct NapMemory {
  uint32_t limit_s = 0;    ///< hookbeh's; 0: it allows none, or that is not known
  double late_from_s = 0;  ///< mission time of the first kept tick that led to a command
  uint32_t variables = 0;  ///< a check value of the mission's variables after the tick before
  bool moved = true;       ///< that tick made a transition, or there was none
  bool late = false;
  bool asleep = false;  ///< a sleep was added to the newest answer
};

/// A tick of a running mission, before its answer.
struct NapTick {
  GliderContext& context;
  const hooks::VehicleTick& tick;
  hooks::Client& client;
  LinkLog& log;
  bool commands = false;  ///< it led to a command
  bool settled = false;   ///< the vehicle obeys, and no instruction waits
};

/// Whether the vehicle has kept this frame while the SBC slept: then `mission_time` is that of it.
bool takeKeptFrame(MissionClock& clock, const hooks::VehicleTick& tick, double sbc_time,
                   double& mission_time);

/// How many sensors of the vehicle it needs that the mission may not have.
inline uint32_t sensorsForNaps(const GliderMission& mission) {
  return mission.naps == nullptr ? 0 : 1;
}
/// The sensor with hookbeh's limit.
inline uint16_t napLimitSensor(const GliderMission& mission) {
  return static_cast<uint16_t>(mission.dictionary->roles[kGliderRoleHookNapSecs]);
}

}  // namespace glider::runtime
