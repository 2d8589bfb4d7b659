// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/store.h"
#include "platforms/load/platform.h"

#include <vector>

/// The environment model of proofs: how the vehicle follows commands. It is wide enough for every
/// flight (tests/world checks thousands of flights against it), and narrow enough to prove
/// something.
///
/// - It sinks and climbs at `vertical_rate_m_s` at most, and never above the surface.
/// - A command to dive to a depth, or to hover at it, never takes it deeper than
///   `inflection_overshoot_m` beyond that, or beyond where it is; a new command never takes it
///   deeper than the new or the previous command would have.
/// - A command to climb that is `turn_s` old lifts it at `slowest_climb_m_s` at least, until it is
///   there. It then hovers there, within the overshoot, and from above sinks to it; a depth above
///   `kFloats` means the surface. For a command to climb further that time starts again: the
///   vehicle may have hovered.
namespace glider::ir::prove {

/// A command to climb to a depth above this (m) ends at the surface: hookbeh does not hover there.
inline constexpr double kFloats = 1;

/// The effect of a command on the vehicle: `arguments` are those of the command, `allowed` where it
/// is given (all arguments known), `now` mission time.
Vehicle obey(const Vehicle& before, Command command, const std::vector<NumberTerm>& arguments,
             const z3::expr& now, const z3::expr& allowed, const platforms::Platform& platform,
             Unknowns& unknowns);

/// The effect of a command that the prover cannot see (of a behaviour in C): any command is
/// possible.
Vehicle obeyAnything(const Vehicle& before, Unknowns& unknowns);

/// The relation between the vehicle at `from` and its depth at `to` (mission time, s) if there is
/// no command in between.
z3::expr moves(const Vehicle& before, const z3::expr& from, const z3::expr& to,
               const z3::expr& depth, const platforms::Platform& platform);

/// The condition of the vehicle when control is given.
z3::expr begins(const Vehicle& vehicle, const platforms::Platform& platform);

}  // namespace glider::ir::prove
