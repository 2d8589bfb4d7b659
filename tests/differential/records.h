// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/random_missions/random_mission.h"

#include <cstdint>
#include <string>
#include <vector>

/// What passes between a test and the program under test (judged_main.cpp), as little-endian words
/// of 64 bits; a number is the bits of a double, with one NaN for all.
///
/// Streams, for each mission: number of parameters and their values, number of ticks, then for
/// each: mission time, number of readings, for each: platform id, raw value. Records, for each
/// tick: number of words that follow; for each action in order: of a C function its list, phase,
/// block of memory and arguments, of a command 100 and its number, how many arguments and they;
/// then state, finished, limit, whether just returned, fired case of each list (UINT32_MAX: none),
/// list and case of the transition, depth of the stack, for each frame: state, time entered, limit;
/// the variables; number of notes, for each: kind, FNV-1a of the text, number of values and they;
/// lost notes; the first condition that fails; the value of each log item. Of a mission that may
/// sleep, while it flies: 1 if it must not now; else 0, the time alone, and for each other cause
/// its kind, sensor and number.
namespace glider::differential {

using Words = std::vector<uint64_t>;

/// A mission with what it will meet.
struct Trial {
  std::string name;  ///< for messages: how to make it again
  ir::Mission mission;
  uint32_t stack_depth = 0;
  std::vector<random_missions::StreamTick> stream;
  std::vector<double> parameters{};
};

/// The trial of `seed`: a random mission, and `ticks` ticks after its start. Its verifier's facts
/// are used. Optimised as `build` does: then one expression stands for many equal ones.
Trial randomTrial(uint64_t seed, size_t ticks, bool optimised);

void appendStream(const Trial& trial, Words& words);
/// What ir/eval says that each tick does, one element a tick.
std::vector<Words> expectedRecords(const Trial& trial);

}  // namespace glider::differential
