// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/fleet/fleet.h"

#include <vector>

namespace glider::simulator {

/// All traces of a flight, which has them once.
inline std::vector<support::Trace> tracesOf(const FleetFlight& flight) {
  std::vector<support::Trace> traces;
  for (size_t i = 0; i < flight.starts.size(); ++i) {
    traces.push_back(flight.take(i));
  }
  return traces;
}

}  // namespace glider::simulator
