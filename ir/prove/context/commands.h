// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>
#include <vector>

namespace glider::ir::prove {

/// Every command that a profile or route may give, in its entry and its cases, including both
/// branches of every `if`, in the order of the text. They are in `mission`, which must outlive
/// them.
std::vector<const Statement*> commandsOf(const Mission& mission, const Activity& activity);

/// Every command that may be given while `state` is current: by its entry and its cases, its
/// profile and its route. For those of `always` see `commandsOfAlways`.
std::vector<const Statement*> commandsOf(const Mission& mission, const State& state);

/// Every command that the cases of `always` may give.
std::vector<const Statement*> commandsOfAlways(const Mission& mission);

/// The target of a SteerTo if it is written as constants; none for other commands.
std::optional<Position> fixedTarget(const Mission& mission, const Statement& statement);

/// The places of the path from which a SteerTo takes its target; empty for other commands, or if
/// the target does not come from a path.
std::vector<Position> pathTargets(const Mission& mission, const Statement& statement);

/// Whether a state always commands the surface when it becomes current: this is then its profile's
/// last command, and the route commands no depth.
bool commandsSurface(const Mission& mission, const State& state);

/// Whether a command is `pump` or `battery`: about the depth, but without a depth to fly to.
bool movesActuators(Command command);
/// Whether a command is about depth and pitch; otherwise it is about the heading.
bool isVertical(Command command);
/// Whether it gives such a command.
bool isVertical(const Statement& statement);

}  // namespace glider::ir::prove
