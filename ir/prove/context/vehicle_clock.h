// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace glider::ir::prove {

/// Rounds a mission time (s) to one that the vehicle's clock, a float of 4 bytes, can represent for
/// three days. A trace with other times cannot be replayed.
inline double onVehicleClock(double mission_time) {
  constexpr double kSteps = 64;
  return std::round(mission_time * kSteps) / kSteps;
}

/// Whether the sensor is a clock of the vehicle, in s: that of the calendar, or the time in its own
/// mission.
inline bool isVehicleClock(const Sensor& sensor) {
  constexpr std::string_view kNames[] = {"m_present_time", "sci_m_present_time",
                                         "m_present_secs_into_mission"};
  return sensor.isOfVehicle() && std::ranges::find(kNames, sensor.vehicle_name) != std::end(kNames);
}

}  // namespace glider::ir::prove
