// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// Every order that a profile or route may give: of its entry and its cases, both sides of every
/// `if`, in the order of the text. They stand in `mission`, which outlives them.
std::vector<const Statement*> commandsOf(const Mission& mission, const Activity& activity);

/// Every command that may be given while `state` is current: by its entry and its cases, its
/// profile's and its route's. Those of `always` are `commandsOfAlways`.
std::vector<const Statement*> commandsOf(const Mission& mission, const State& state);

/// Every command that the cases of `always` may give.
std::vector<const Statement*> commandsOfAlways(const Mission& mission);

/// Where a SteerTo steers to if that is written out; none of another order.
std::optional<Position> fixedTarget(const Mission& mission, const Statement& order);

/// The places of the path from which a SteerTo takes its own; none of another order, or if they
/// come from no path.
std::vector<Position> pathTargets(const Mission& mission, const Statement& order);

/// Whether a command is about depth and pitch; else it is about the heading.
bool isVertical(Command command);

}  // namespace glider::ir::prove
