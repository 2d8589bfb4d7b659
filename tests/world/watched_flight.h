// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/load/loaded_mission.h"
#include "compiler/compilation.h"
#include "support/result.h"
#include "tests/world/conditions.h"
#include "tests/world/environment_check.h"

#include <array>
#include <memory>
#include <string>

namespace glider::tests {

/// A compiled mission that can be flown any number of times, also at the same time.
struct FlyingMission {
  std::string name;
  std::shared_ptr<const compiler::Optimised> flown;
  std::shared_ptr<const codegen::LoadedMission> loaded;
};

/// Compiles the mission `text` in place of the file `path`. As compileText and loadHere; a mission
/// with errors is our own bug.
support::Result<FlyingMission> loadMission(const std::string& path, std::string text);

/// What was seen of a flight.
struct Seen {
  std::optional<Broken> broken;
  std::array<Use, kRules> uses = {};
  double in_control_s = 0;  ///< how long it was watched
  bool refused = false;     ///< it was watched until hookbeh refused a command
};

/// Flies it in process and checks it against the environment model from when control is given until
/// it ends: by `exit`, by a release of control, by an abort, or by a command that hookbeh refuses.
/// Where the lines are whole a command counts from the tick that gives it, else from the cycle in
/// which hookbeh obeys it. Readings, which may be of old frames, are not checked then; nor are gaps
/// between ticks where
/// the SBC's program does not run all the time. As simulate.
support::Result<Seen> flyWatched(const FlyingMission& mission, const Conditions& conditions,
                                 const platforms::Platform& platform);

}  // namespace glider::tests
