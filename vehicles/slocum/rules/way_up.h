// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/rules/layers.h"
#include "vehicles/slocum/rules/whole.h"

#include <span>
#include <string>
#include <vector>

namespace glider::slocum::rules {

/// How the layers bring the vehicle to the surface once hookbeh commands nothing.
struct WayUp {
  std::vector<Part> parts;
  std::string by;
  std::string why_not;  ///< empty: it is proved
  std::string change;
  support::SourceRange range;  ///< of what prevents it; if it is proved, of the behaviour
};

/// `deepest_m`: of all that the layers and the mission command.
WayUp wayUp(std::span<const Layer> layers, const slocum::MissionFile& vehicle,
            const platforms::Platform& platform, double deepest_m);

/// From the command to climb, at `from_m` or above, to the surface.
std::vector<Part> climbParts(const platforms::Platform& platform, double from_m);

}  // namespace glider::slocum::rules
