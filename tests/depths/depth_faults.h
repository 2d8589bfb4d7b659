// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"

#include <string>
#include <vector>

namespace glider::tests {

/// What may be expected of the depth under a fault.
enum class DepthRule : uint8_t {
  Wrong,  ///< stuck, missing or jumping: 10 m past max_depth at most
  False,  ///< a slow drift or a scale: the same where there is a CTD
  Two,    ///< two sensors at once: one and a half times max_depth at most
};

/// One or two sensors that are wrong from a time of the flight on.
struct DepthFault {
  std::string name;  ///< "m_depth frozen"
  DepthRule rule = DepthRule::Wrong;
  std::vector<simulator::SensorFault> sensors;
  [[nodiscard]] simulator::Faults from(double begin_s) const;
  /// The same without what is wrong with one of its sensors: for one sensor nothing remains.
  [[nodiscard]] std::vector<DepthFault> parts() const;
};

/// Each sensor that hookbeh and the flight control read, but the altimeter, in each way that one
/// can be wrong.
std::vector<DepthFault> singleDepthFaults();
/// Pairs of such as touch the depth: of two different sensors.
std::vector<DepthFault> doubleDepthFaults();
/// The same of the altimeter, alone and with another sensor: for flights over a bottom in range.
std::vector<DepthFault> altimeterFaults();
/// A vehicle without a CTD.
simulator::SensorFault noCtd();

}  // namespace glider::tests
