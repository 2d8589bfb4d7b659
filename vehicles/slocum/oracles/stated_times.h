// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"
#include "vehicles/slocum/oracles/names.h"

#include <string>
#include <vector>

namespace glider::slocum::oracles {

/// A time of the flight in which hookbeh may not be active.
struct Release {
  Span when;
  std::string why;
};

/// What hooks/protocol/README.md ("Watchdogs") promises, for one flight.
struct StatedTimes {
  std::vector<Release> releases;
  /// While hookbeh is active, the longest time since the SBC's mission last made progress, s.
  double most_standstill_s = 0;
  /// While hookbeh is active, the longest time in which it answers an instruction of the SBC, s.
  double most_unanswered_s = 0;
};

StatedTimes statedTimes(const Faults& faults, const ControlTimes& times);

}  // namespace glider::slocum::oracles
