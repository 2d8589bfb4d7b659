// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/scenario/scenario.h"

#include <functional>
#include <string>
#include <vector>

namespace glider::tests {

/// What hooks/hookbeh/README.md guarantees about contacts with the bottom.
enum class BottomRule : uint8_t {
  Never,  ///< the vehicle does not touch the bottom
  Once,   ///< at most once at a place
  Rare,   ///< the same before its first echoes; afterwards almost never
};

/// An altimeter that is wrong in one way. `apply` changes a scenario, whose fault begins at
/// `from_s`.
struct AltimeterFault {
  std::string name;
  BottomRule rule = BottomRule::Once;
  std::function<void(simulator::Scenario& scenario, double from_s)> apply;
  bool unread = false;  ///< the mission file has it read only when a behaviour asks for it
};

/// The first has no fault.
const std::vector<AltimeterFault>& altimeterFaults();

}  // namespace glider::tests
