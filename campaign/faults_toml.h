// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/campaign/draw_faults.h"

#include <string>

namespace glider::campaign {

/// The faults of a flight, as the [faults] tables of a scenario file.
std::string faultsToToml(const simulator::Faults& faults);
/// The same, and as comments what a campaign changed in the environment and in the mission file.
std::string drawnToText(const simulator::DrawnFaults& drawn);

}  // namespace glider::campaign
