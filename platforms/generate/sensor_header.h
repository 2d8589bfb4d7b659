// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

#include <string>

namespace glider::platforms {

/// The C header of a vehicle's sensors, for code on board that is made for this vehicle: their
/// numbers (GLIDER_M_DEPTH), the limits of the hull (GLIDER_HULL_…), and, where
/// GLIDER_DEFINE_DICTIONARY or GLIDER_DEFINE_VEHICLE is defined before it is included, the tables
/// that hooks (hooks/protocol/dictionary.h) and missions in C (runtime/c/vehicle.h) need.
std::string sensorHeader(const Platform& platform);

}  // namespace glider::platforms
