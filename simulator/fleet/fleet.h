// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/acoustics/trouble.h"
#include "simulator/fleet/separations.h"
#include "simulator/simulator.h"

#include <functional>
#include <vector>

namespace glider::simulator {

/// What is known of the flight of a fleet: where each vehicle starts, and their distances.
struct FleetFlight {
  std::vector<TruePlace> starts;
  Separations separations;
  /// The trace of the vehicle with that number, with positions relative to its own start. Once for
  /// each.
  std::function<support::Trace(size_t vehicle)> take;
};

/// A vehicle of a fleet. Its scenario says where it starts; the water of that scenario is not used.
struct FleetMember {
  SimulationSetup setup;
  uint32_t number =
      0;  ///< of its random numbers; those of number 0 are the same as of a vehicle alone
};

/// Flies several vehicles in one ocean and one time, each until its own end. The origin of all
/// positions in m, and the water, are those of `world`; so is the seed of what is lost between
/// their modems, which `trouble` disturbs. A vehicle flies byte for byte as it does without the
/// others, unless it talks with them. `progress` (may be empty) is called about every 100 s of
/// virtual time, with the time and how many still fly. Fails as simulate does.
support::Result<FleetFlight> simulateFleet(
    const Scenario& world, std::vector<FleetMember> members,
    const std::function<void(double now_s, size_t flying)>& progress = {},
    AcousticTrouble trouble = {});

}  // namespace glider::simulator
