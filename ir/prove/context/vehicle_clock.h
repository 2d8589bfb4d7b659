// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

#include <cmath>

namespace glider::ir::prove {

/// Rounds a mission time (s) to one that the vehicle's clock, a float of 4 bytes, can represent for
/// three days. A trace with other times cannot be replayed.
inline double onVehicleClock(double mission_time) {
  constexpr double kSteps = 64;
  return std::round(mission_time * kSteps) / kSteps;
}

/// Whether a sensor (null: none of the vehicle's) is its clock of the calendar.
inline bool isCalendarClock(const platforms::PlatformSensor* sensor) {
  return sensor != nullptr && sensor->unit == "timestamp";
}

/// Whether it is that, or the time in the vehicle's own mission.
inline bool isVehicleClock(const platforms::PlatformSensor* sensor) {
  return isCalendarClock(sensor) ||
         (sensor != nullptr && sensor->name == "m_present_secs_into_mission");
}

}  // namespace glider::ir::prove
