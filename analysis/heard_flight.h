// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/load/loaded_mission.h"
#include "compiler/compilation.h"
#include "flights/heard_ticks.h"
#include "flights/in_process_sbc.h"
#include "simulator/scenario/scenario.h"
#include "support/result.h"
#include "support/trace/trace.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glider::analysis {

/// A simulated flight with what the SBC received, so that the interpreter can repeat it.
struct HeardFlight {
  std::vector<flights::HeardTick> ticks;
  support::Trace trace;
};

/// Where a flight takes place.
struct World {
  simulator::Scenario scenario;
  uint64_t seed = 1;
};

/// Flies the mission, whose SBC `start` starts, also after a power cut. Fails as that and
/// simulating do.
support::Result<support::Trace> fly(const compiler::Optimised& mission, simulator::StartSbc start,
                                    World world);

/// Flies the compiled mission in this process, in a scenario that comes with glidercc or that is in
/// a file. What the SBC receives is recorded until it loses its power. Fails as choosing the
/// scenario and simulating do.
support::Result<HeardFlight> flyHeard(const compiler::Optimised& mission,
                                      std::shared_ptr<const codegen::LoadedMission> loaded,
                                      const std::vector<double>& parameters,
                                      const std::string& scenario, uint64_t seed);

/// The scenarios that come with glidercc, the default one first.
std::vector<std::string> scenariosInOrder();

}  // namespace glider::analysis
