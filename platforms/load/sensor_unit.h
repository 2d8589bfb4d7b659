// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

namespace glider::platforms {

/// Sets kind, dimension and factor from the sensor's unit; false when the unit is not a valid one.
bool interpretUnit(PlatformSensor& sensor);

}  // namespace glider::platforms
