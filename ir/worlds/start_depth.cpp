// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/worlds/start_depth.h"

#include "ir/worlds/under_assumptions.h"
#include "platforms/load/surface_reading.h"

#include <algorithm>

namespace glider::ir {

double startReading(const Mission& mission, const platforms::Platform& platform) {
  const platforms::EnvironmentModel world = underAssumptions(platform, mission).world;
  return std::max(world.start_depth_m - world.depth_error_m, platforms::kSurfaceReadingM);
}

}  // namespace glider::ir
