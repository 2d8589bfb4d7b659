// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/sbc_choice.h"
#include "simulator/scenario/scenario.h"
#include "simulator/simulator.h"
#include "tests/world/watched_flight.h"
#include "vehicles/slocum/port_files/mission_port.h"

#include <cstdint>

/// Flights by the port of a vehicle without the hooks.
namespace glider::tests {

/// The files of a mission's port, and its scenario.
struct PortFlight {
  slocum::PortPlan plan;
  simulator::Scenario scenario;
};

/// Plans it; the vehicle of `scenario` then flies the mission file. A mission that has no room on
/// the port, or a file that cannot be read, is our own bug.
PortFlight planned(const FlyingMission& mission, simulator::Scenario scenario,
                   const slocum::PortChoice& choice);

/// The program's end of the port.
flights::PortEnd portEnd(const PortFlight& flight);

/// A flight with the mission's program as the SBC, which starts again after a power cut.
simulator::SimulationSetup setupOf(const FlyingMission& mission, const PortFlight& flight,
                                   uint64_t seed);

}  // namespace glider::tests
