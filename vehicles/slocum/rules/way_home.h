// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/worlds/worlds.h"
#include "platforms/load/platform.h"
#include "vehicles/own_mission.h"

#include <string>
#include <vector>

namespace glider::slocum::rules {

/// How long after the last sign of the SBC's life hookbeh releases control, and where the number is
/// from. If the SBC dies in a nap, hookbeh still counts the beats on its behalf for `nap_secs`.
struct Silence {
  double seconds = 0;
  std::string source;  ///< "silence_secs of skeleton.mi"
};

/// The silence that hookbeh uses if its mission file gives none.
Silence usualSilence();
/// The same while it gives control to `mission`. If that lets the SBC sleep, its file must say how
/// long the beats on behalf of a sleeping SBC count: as long as that mission needs.
Silence usualSilence(const ir::Mission& mission);

/// The shortest `nap_secs` with which hookbeh does not release control in a nap: the
/// last of a nap is the time to wake.
double napSecsFor(double nap_s);

/// The way home from a depth of at most `depth_m`, the deepest that commands lead to: hookbeh
/// releases control after its silence and two of the longest cycles, then the vehicle's own layers
/// climb as the platform says. This holds for a mission file that surfaces whenever nothing else
/// commands the vehicle.
vehicles::WayHome wayHomeFrom(double depth_m, const platforms::Platform& platform,
                              const Silence& silence = usualSilence());

/// Lines for the report: the way home of a mission, and of states where it is shorter.
std::vector<std::string> wayHomeLines(const ir::WidestWorld& world, const Silence& silence);

}  // namespace glider::slocum::rules
