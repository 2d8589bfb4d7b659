// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <optional>

namespace glider::ir {

/// Whether a place (degrees, north and east positive) is inside the corners of `area`, a polygon,
/// as `inside` of the language counts.
bool isInside(const Geofence& area, const Position& place);

/// The area in which control is assumed to be given; none: nothing is assumed.
std::optional<Geofence> assumedStart(const Mission& mission);

}  // namespace glider::ir
