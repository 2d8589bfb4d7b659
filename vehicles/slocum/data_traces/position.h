// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_tables/dddmm.h"
#include "vehicles/slocum/data_traces/quantities.h"
#include "vehicles/slocum/data_traces/samples.h"

#include <string>
#include <vector>

namespace glider::slocum {

/// The sensors that positions() and currents() use.
std::vector<std::string> positionSensors();

/// The dead-reckoned positions, the GPS fixes and the waypoints at `times_s`, in degrees; the first
/// two also in m east and north of the first position.
std::vector<FlightColumn> positions(const Merged& merged, const std::vector<double>& times_s);

/// The depth-averaged current at `times_s`, in m/s towards true east and north: each estimate from
/// when the vehicle made it to the next one. Of the estimates between two dives, which the vehicle
/// improves with each GPS fix, only the last is used. `note`: what the reader must know about it.
std::vector<FlightColumn> currents(const Merged& merged, const Samples& depth,
                                   const std::vector<double>& times_s, std::string& note);

}  // namespace glider::slocum
