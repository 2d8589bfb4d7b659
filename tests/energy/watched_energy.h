// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/energy/energy_bound.h"
#include "ir/prove/falsification/rng.h"
#include "simulator/scenario/scenario.h"
#include "tests/world/watched_flight.h"

#include <cstdint>
#include <functional>
#include <optional>

/// Flights whose energy is compared with its bound.
namespace glider::tests {

/// What the usual board draws.
const platforms::BoardPower& usualBoardPower();

/// As energyBoundOf, for the parameters as written.
std::optional<ir::prove::EnergyBound> boundOfEnergy(const FlyingMission& mission,
                                                    const platforms::Platform& platform,
                                                    const platforms::BoardPower& board);

/// Each device of the vehicle takes what the power table says times 1 plus `share` of its spread:
/// `share` is asked for each, the SBC, which is `board`, last.
void setHunger(simulator::VehicleSettings& vehicle, const platforms::BoardPower& board,
               const std::function<double()>& share);

/// Still water for a day, with a mission file that lets dives go to 200 m.
simulator::Scenario deepSea();

/// The scenario with another of the seas that a bound is for, on a healthy vehicle. Half of the
/// seas have a swell, half are as shallow as they may be: hookbeh does not have to turn the
/// vehicle, which no bound counts. Half of the vehicles take all of their spread.
simulator::Scenario drawSea(simulator::Scenario scenario, const ir::prove::EnergyBound& bound,
                            ir::prove::Rng& dice);

/// What a flight took while the SBC had control and hookbeh did what it said.
struct FlownEnergy {
  double nearest = 0;  ///< the greatest share of the bound at any time
  double used_j = 0, seconds = 0;
};

/// Flies it in process. As simulate.
FlownEnergy flyForEnergy(const FlyingMission& mission, const ir::prove::EnergyBound& bound,
                         const simulator::Scenario& scenario, uint64_t seed);

}  // namespace glider::tests
