// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/random_missions/random_mission.h"

/// What passes between a test and the judged program (judged_main.cpp), as little-endian words of 64 bits; a number is the bits
/// of a double, with one NaN for all.
///
/// Streams, for each mission: number of ticks, then for each: mission time, number of readings, for each: platform id, raw value.
/// Records, for each tick: number of words that follow; for the profile and then the route, unless the mission is
/// finished: its block of memory, the phase, its arguments; then state, finished, fired case (UINT32_MAX: none), depth of the
/// stack, for each frame: state, time entered; then the value of each log item.
namespace glider::differential {

using Words = std::vector<uint64_t>;

/// A mission with what it will meet.
struct Trial {
  std::string name;  ///< for messages: how to make it again
  ir::Mission mission;
  uint32_t stack_depth = 0;
  std::vector<random_missions::StreamTick> stream;
};

/// The trial of `seed`: a random mission, and `ticks` ticks after its start. Its verifier's facts are used.
Trial randomTrial(uint64_t seed, size_t ticks);

void appendStream(const Trial& trial, Words& words);
/// What ir/eval says that each tick does, one element a tick.
std::vector<Words> expectedRecords(const Trial& trial);

}  // namespace glider::differential
