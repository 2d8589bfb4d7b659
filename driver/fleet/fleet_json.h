// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/json_document.h"
#include "report/fleet/fleet_report.h"

#include <string>

namespace glider::driver {

/// The content of fleet.json: the vehicles, their figures and problems, and the least distance of
/// each pair (null: they never flew at the same time).
Json fleetJson(const report::FleetReport& fleet);

/// The distances of all pairs as CSV: time (s), then a column for each pair, m; the least since the
/// time before. Empty cells while the two do not both fly.
std::string distancesCsv(const report::FleetReport& fleet);

}  // namespace glider::driver
