// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

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

}  // namespace glider::platforms
