// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <vector>

namespace glider::ir::prove {

/// Where a mission may steer.
struct Steering {
  std::vector<Position> waypoints;  ///< their hull holds every waypoint that it may command
  bool by_heading = false;  ///< it may also steer by a heading, by none, or to any place at all
};

/// By all of its commands, wherever they stand: a command stays in force until the next, through
/// calls, returns and states whose route commands nothing. Before the first it goes straight on, so
/// it steers by no heading at first unless the start surely commands one. A profile or route in C
/// may command anything.
Steering steeringOf(const ProofContext& proof_context);

}  // namespace glider::ir::prove
