// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/eval/interpreter.h"

#include <cstdint>
#include <vector>

/// Random missions and sensor streams for tests that hold two ways of running a mission against
/// each other.
namespace glider::random_missions {

/// The mission of `seed`: valid, free of verification errors, of 1 to 12 states that lead to each
/// other a lot, with every construct, every operation and many unknowns. Its states use a profile
/// and a route written in the language, or in C; a test implements the latter to record their
/// arguments (runtime/abi/behaviour.h), as it does the vehicle's commands:
///     void gliderProfileRecord(GliderContext*, GliderBehaviourMemory*, uint32_t phase,
///                              double number, double length, double time, double temperature);
///     void gliderRouteRecord(GliderContext*, GliderBehaviourMemory*, uint32_t phase,
///                            double number, double latitude, double longitude);
/// Some call C functions, and have a sensor of the SBC's own; external_functions.h says what these
/// give:
///     double gliderTestLevel(void);
///     double gliderTestMixed(double, double, double);
///     double gliderTestMet(double, double, double, double, double, double, double, double);
///     double gliderTestPing(double mission_time);
ir::Mission randomMission(uint64_t seed);

/// The same with a block that runs in every tick, which only what flies has: proofs ignore it.
ir::Mission flownMission(uint64_t seed);

/// The C functions of random missions (tests/random_missions/external_functions.h), for one run.
ir::Externals randomExternals();

/// Values for the parameters of `mission`, in their ranges, that satisfy its conditions.
std::vector<double> randomParameters(const ir::Mission& mission, uint64_t seed);

/// The mission time (s) and readings of one tick.
struct StreamTick {
  double mission_time = 0;
  std::vector<ir::SensorUpdate> frame;  ///< no sensor twice
};

/// `ticks` + 1 ticks for `mission`, the first for the start at 0 s: steps of mostly 4 s, at times
/// none, backwards or long ones; sensors that fall silent; readings that wander, jump, repeat,
/// are at or beyond the ends of their range, and special ones (NaN with and without the quiet
/// bit, infinities, minus zero, subnormals, the largest numbers).
std::vector<StreamTick> randomStream(const ir::Mission& mission, uint64_t seed, size_t ticks);

}  // namespace glider::random_missions
