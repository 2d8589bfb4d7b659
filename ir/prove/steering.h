// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/ground.h"

#include <vector>

namespace glider::ir::prove {

/// Where a mission may steer.
struct Steering {
  std::vector<Position>
      waypoints;            ///< every place between which it is steered to lies in their hull
  bool by_heading = false;  ///< it may also steer by a heading, or by none, or anywhere
};

/// Of all routes of the mission, whatever their variables are.
Steering steeringOf(const Ground& ground);

}  // namespace glider::ir::prove
