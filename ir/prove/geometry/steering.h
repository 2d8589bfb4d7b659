// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <string>
#include <vector>

namespace glider::ir::prove {

/// Where a mission may steer.
struct Steering {
  std::vector<Position> waypoints;  ///< their hull contains every one that it may command
  bool by_heading = false;  ///< it may also steer by a heading, by none, or to any place at all
  std::string where;        ///< it does, first: "at the start", "in `survey`"
};

/// From all commands of the mission, in any state: a command stays in force until the next, through
/// calls, returns and states whose route commands nothing. Before the first command the vehicle
/// goes straight on, which counts as steering by no heading unless the start certainly commands
/// one. A profile or route in C may command anything.
Steering steeringOf(const ProofContext& proof_context);

}  // namespace glider::ir::prove
