// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

namespace glider::platforms {

/// Adds the sensors of seat_sensors.def after those of the file, unless it has one with the role.
void addSeatSensors(Platform& platform);

}  // namespace glider::platforms
