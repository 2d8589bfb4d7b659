// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>

namespace glider::tests {

/// A mission of `seed` in the mission language that flies: a few states that lead to each other by
/// clocks, depths and temperatures, with every profile of the library and bare commands, depths
/// down to 55 m, pitches that scenarios/skeleton.mi takes, a parameter; it exits after 1 to 3 h.
std::string randomMissionText(uint64_t seed);

}  // namespace glider::tests
