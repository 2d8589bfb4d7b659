// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/scenario/scenario.h"
#include "tests/world/watched_flight.h"

#include <cstdint>
#include <vector>

/// What the flights of tests/world are made from.
namespace glider::tests {

/// The environment's number `name`, or `standard`.
uint64_t wanted(const char* name, uint64_t standard);

/// The platform of all missions.
const platforms::Platform& slocum();

/// The paper's missions, the gallery and `random` random ones from seed `seed` on, loaded.
std::vector<FlyingMission> missions(uint64_t random, uint64_t seed);

/// All that come with glidercc in which the SBC can have control, `default` among them.
std::vector<simulator::Scenario> scenarios();

}  // namespace glider::tests
