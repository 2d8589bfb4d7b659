// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/random_missions/random_mission.h"

#include <cstdint>
#include <string>

namespace glider::naps {

/// The text of a mission for which much can be foreseen: guards of few parts, profiles of the
/// library and its own, truth values that cases set, numbers that sensors meet exactly.
std::string sleepyMission(uint64_t seed);

/// A stream of `ticks` + 1 ticks for it: readings that wander slowly, at whole numbers, with
/// silences, unknown and impossible values.
std::vector<random_missions::StreamTick> slowStream(const ir::Mission& mission, uint64_t seed,
                                                    size_t ticks);

}  // namespace glider::naps
