// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace glider::platforms {

/// An instrument of the science computer that missions switch by `sample`: [[instrument]]. Its
/// place in the file is its place in the word of hooks/protocol/sampling.h.
struct Instrument {
  std::string name;                  ///< what missions write, and its device in the power table
  std::string vehicle_name;          ///< its switch on the vehicle: "c_profile_on"
  std::vector<std::string> sensors;  ///< the vehicle's names of what it measures
  double shortest_s = 0;             ///< between two readings
  double reading_s = 0;              ///< for which it is on, for one reading
};

/// That which measures a sensor, by the vehicle's name; null: none that missions switch.
inline const Instrument* measuring(const std::vector<Instrument>& instruments,
                                   const std::string& sensor) {
  const auto found = std::ranges::find_if(instruments, [&](const Instrument& one) {
    return std::ranges::find(one.sensors, sensor) != one.sensors.end();
  });
  return found == instruments.end() ? nullptr : &*found;
}

}  // namespace glider::platforms
