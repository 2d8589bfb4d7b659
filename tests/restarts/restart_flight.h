// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/requirement_watch.h"
#include "simulator/faults/faults.h"
#include "support/trace/trace.h"
#include "tests/world/watched_flight.h"

#include <string>
#include <vector>

namespace glider::tests {

/// A flight, and what its watch has found.
struct RestartFlight {
  support::Trace trace;
  std::vector<flights::FlownViolation> violations;

  /// How many events contain `what`.
  [[nodiscard]] size_t count(const std::string& what) const;
  [[nodiscard]] size_t count(support::EventId id) const;
  /// How often a transition led to the state: by goto or call, in the whole flight.
  [[nodiscard]] size_t visits(const std::string& state) const;
  /// The greatest true depth in the cycles in which the state was current and the SBC had control,
  /// m; 0: there were none.
  [[nodiscard]] double deepestIn(const std::string& state) const;
  /// From the first to the last cycle in which the SBC had control, s.
  [[nodiscard]] double flown() const;
};

/// Compiles and loads the mission.
FlyingMission loadText(const std::string& text);

/// The scenario `default` with these faults.
RestartFlight flyRestarts(const FlyingMission& mission, const simulator::Faults& faults,
                          double duration_s);

}  // namespace glider::tests
