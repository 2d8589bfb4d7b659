// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/load/loaded_mission.h"
#include "compiler/compilation.h"
#include "support/result.h"
#include "tests/world/assumed_world.h"
#include "tests/world/conditions.h"

#include <array>
#include <memory>
#include <string>

namespace glider::tests {

/// A compiled mission that can be flown as often as wanted, also at the same time.
struct FlyingMission {
  std::string name;
  std::shared_ptr<const compiler::Optimised> flown;
  std::shared_ptr<const codegen::LoadedMission> loaded;
};

/// Compiles the mission `text`, which stands in for the file `path`. As compileText and loadHere;
/// a mission with mistakes is our own bug.
support::Result<FlyingMission> loadMission(const std::string& path, std::string text);

/// What was seen of a flight.
struct Seen {
  std::optional<Broken> broken;
  std::array<Use, kRules> uses = {};
  double in_control_s = 0;  ///< how long it was watched
  bool refused = false;     ///< it was watched until hookbeh refused a command
};

/// Flies it in process and holds it to the assumed world from when control is given until it ends:
/// by `exit`, by hand-back, by an abort, or by a command that hookbeh refuses. Where the lines are
/// whole a command counts from the tick that gives it, else from the cycle in which hookbeh obeys
/// it, and readings, which may be of old frames, are not judged; nor are gaps between ticks where
/// the SBC's program does not run all the time. As simulate.
support::Result<Seen> flyWatched(const FlyingMission& mission, const Conditions& conditions,
                                 const platforms::Platform& platform);

}  // namespace glider::tests
