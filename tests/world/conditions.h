// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/prove/falsification/rng.h"
#include "simulator/campaign/draw_faults.h"
#include "simulator/scenario/scenario.h"

#include <cstdint>
#include <string>
#include <vector>

namespace glider::tests {

/// What a flight meets: a world, a vehicle, faults that leave it healthy, values of the parameters.
struct Conditions {
  simulator::Scenario scenario;
  std::vector<double> parameters;  ///< one each, as the mission allows them
  uint64_t seed = 0;               ///< of the noise
  simulator::FaultKind kind = simulator::FaultKind::None;
  /// No line, computer or power is damaged: commands and frames get through at once.
  bool whole = true;
  bool program_runs =
      true;  ///< the SBC's program, all the time: it ticks though the lines are dead
  /// The vehicle's own mission file waits at the surface until the SBC takes control.
  bool from_surface = true;
};

/// Draws them for a flight of `mission` in a world that begins as `scenario`; the same for the same
/// `seed`. Half of the flights are in the scenario's own water. Not drawn: faults of the sensors
/// m_depth, m_pitch and of the vehicle's clock, without which the vehicle is not healthy.
Conditions drawConditions(const ir::Mission& mission, const simulator::Scenario& scenario,
                          uint64_t seed);

/// Draws currents, a wave and a thermocline, as they may be on another day.
void drawWater(simulator::OceanSettings& ocean, ir::prove::Rng& dice);

}  // namespace glider::tests
