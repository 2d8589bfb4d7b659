// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/picture/polyline.h"
#include "support/trace/trace.h"

#include <vector>

namespace glider::report::picture {

/// The different waypoints that the vehicle steered to, in the order of their first use, in metres
/// east (x) and north (y) as true_x and true_y; only those within a flight's extent of the track.
/// Empty if there are so many that the mission steers to moving points.
std::vector<Dot> waypointsOf(const support::Trace& trace);

}  // namespace glider::report::picture
