// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>

namespace glider::ir {

/// Whether a place (degrees, north and east positive) is inside the corners of `area`, a polygon,
/// as `inside` of the language counts.
bool isInside(const Geofence& area, const Position& place);

/// A polygon that holds a disc, and whose corners are at most 6 % farther from its centre than its
/// radius; empty for a disc that is too large, or too near a pole, for such corners.
std::optional<Geofence> polygonAround(const Geofence& disc);

/// The area in which control is assumed to be given; none: nothing is assumed.
std::optional<Geofence> assumedStart(const Mission& mission);

}  // namespace glider::ir
