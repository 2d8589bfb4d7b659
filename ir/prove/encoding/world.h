// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/store.h"
#include "platforms/load/platform.h"

#include <vector>

/// How the vehicle that proofs assume obeys: wide enough for every flight (tests/world flies
/// thousands against it), narrow enough to prove something.
///
/// - It sinks and climbs at `vertical_rate_m_s` at most, and never above the surface.
/// - A command to dive to a depth, or to hover at it, never takes it deeper than
///   `inflection_overshoot_m` beyond that, or beyond where it is; a new command never deeper than
///   it or the one before would have.
/// - A command to climb, `turn_s` old, lifts it at `slowest_climb_m_s` at least, until it is there.
///   There it hovers, give or take the overshoot, and from above it sinks to it; a depth above
///   `kFloats` means the surface. A command to climb further counts anew: it may have hovered.
namespace glider::ir::prove {

/// A command to climb to a depth above this (m) ends at the surface: hookbeh does not hover there.
inline constexpr double kFloats = 1;

/// What a command does to the vehicle that is ordered: `arguments` are its own, `allowed` where it
/// is given (all arguments known), `now` mission time.
Vehicle obey(const Vehicle& before, Command command, const std::vector<NumberTerm>& arguments,
             const z3::expr& now, const z3::expr& allowed, const platforms::Platform& platform,
             Unknowns& unknowns);

/// After a command that the prover cannot see (a behaviour in C): any there is.
Vehicle obeyAnything(const Vehicle& before, Unknowns& unknowns);

/// What holds between the vehicle at `from` and its depth at `to` (mission time, s) if no command
/// comes in between.
z3::expr moves(const Vehicle& before, const z3::expr& from, const z3::expr& to,
               const z3::expr& depth, const platforms::Platform& platform);

/// What holds of it when control is given.
z3::expr begins(const Vehicle& vehicle, const platforms::Platform& platform);

}  // namespace glider::ir::prove
