// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/vehicle.h"

#include <memory>

/// Flights of a campaign in which the vehicle has no hooks and is steered by its port.
namespace glider::vehicles {

/// Whether the vehicle in `scenario` is such a one.
bool isFlownByPort(const simulator::Scenario& scenario);

/// Whether such a vehicle promises anything about flights with a fault of this kind.
bool portPromises(simulator::FaultKind kind);

/// Checks a flight of such a vehicle; null: it is not one.
std::unique_ptr<simulator::Judge> makePortJudge(const FlightToJudge& flight);

}  // namespace glider::vehicles
