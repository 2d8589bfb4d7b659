// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/encoding/store.h"
#include "platforms/load/platform.h"

#include <vector>

/// The environment model of proofs in terms of Z3: how the vehicle follows commands, by the rules
/// V1 to V6 of docs/verification.md (context/vehicle_rules.h). It is wide enough for every flight
/// (tests/world checks thousands of flights against it), and narrow enough to prove something.
namespace glider::ir::prove {

/// V3 to V5, the effect of a command on the vehicle: `arguments` are those of the command,
/// `allowed` where it is given (all arguments known), `now` mission time.
Vehicle obey(const Vehicle& before, Command command, const std::vector<NumberTerm>& arguments,
             const z3::expr& now, const z3::expr& allowed, const platforms::Platform& platform,
             Unknowns& unknowns);

/// V6, the effect of a command that the prover cannot see (of a behaviour in C): any command is
/// possible.
Vehicle obeyAnything(const Vehicle& before, Unknowns& unknowns);

/// V2, the relation between the vehicle at `from` and its depth at `to` (mission time, s) without
/// a command in between.
z3::expr moves(const Vehicle& before, const z3::expr& from, const z3::expr& to,
               const z3::expr& depth, const platforms::Platform& platform);

/// V2, whether the climb in force has certainly brought the vehicle to `limit` (m) or above by `to`
/// (mission time, s), and holds it there until another command.
z3::expr hasClimbedTo(const Vehicle& before, const z3::expr& to, const z3::expr& limit,
                      const platforms::Platform& platform);

/// V1, the condition of the vehicle when control is given.
z3::expr begins(const Vehicle& vehicle, const platforms::Platform& platform);

}  // namespace glider::ir::prove
