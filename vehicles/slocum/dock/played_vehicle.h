// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/dock/dock.h"

#include <cstdint>
#include <string>
#include <vector>

namespace glider::slocum {

/// What the played vehicle does in a control cycle.
enum class DockScene : uint8_t {
  Prompt,        ///< it flies nothing
  OtherMission,  ///< a mission file that was not built with the program
  OwnMission,    ///< the one that was
  PromptAgain,   ///< its mission has ended
};

/// A control cycle of the played vehicle.
struct DockCycle {
  DockScene scene = DockScene::Prompt;
  double clock_s = 0;
  double mission_s = 0;        ///< since its mission began
  bool restarts_port = false;  ///< its end of the port goes and comes back before
};

/// The cycles of a check that lasts `count` of them, from `clock_s` on.
std::vector<DockCycle> playCycles(uint32_t count, double clock_s);

/// The number that another mission file has.
uint32_t otherProgram(uint32_t program);

/// The bodies in which a vehicle at the surface reports all sensors of the list; the last has its
/// clock.
std::vector<std::string> reportOf(const DockCycle& cycle, const DockSetup& setup);

}  // namespace glider::slocum
