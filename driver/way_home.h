// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <string>
#include <vector>

namespace glider::driver {

/// What becomes of the vehicle if the SBC dies or falls silent.
struct WayHome {
  double depth_m = 0;    ///< no deeper is it then, by the mission's orders
  double surface_s = 0;  ///< from the SBC's last word until it is at the surface, at most
};

/// From where no orders lead deeper than `depth_m`: hookbeh lets go after its silence and two
/// cycles, then the vehicle's own layers climb as the platform says. For the b_args that hookbeh
/// has if the mission file gives none, and a mission file that surfaces whenever nothing else
/// commands.
WayHome wayHomeFrom(double depth_m, const platforms::Platform& platform);

/// Lines for the report: the way home of a mission, and of states where it is shorter.
std::vector<std::string> wayHomeLines(const ir::Mission& mission,
                                      const platforms::Platform& platform);

}  // namespace glider::driver
