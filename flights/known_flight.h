// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "flights/heard_missions.h"
#include "flights/requirement_watch.h"

#include <optional>
#include <string>

namespace glider::flights {

/// What one mission of a flight is checked with.
struct KnownFlight {
  const compiler::Optimised& mission;
  const HeardMission& heard;
  const std::vector<double>& parameters;
  const support::Trace& trace;
};

/// What one mission of a flight did with a requirement.
struct KnownOutcome {
  std::optional<FlownViolation> violation;  ///< the first, without its number
  std::string undecided;  ///< why the mission could neither keep nor violate it; empty: it kept it
};

/// What a mission did with `required`. The interpreter repeats the mission under the requirement's
/// monitor. After an outage both continue with what they knew at the tick of the checkpoint, as the
/// mission does, so that nothing is counted twice that the mission did twice. Ticks that the
/// mission has forgotten are checked too: they have happened. `to_end`: it was not begun again, so
/// that after its last tick it did nothing until the end of the flight; unless the SBC failed then,
/// with which the mission is over.
KnownOutcome outcomeOf(const ir::Requirement& required, const KnownFlight& flight, bool to_end);

/// The outages of the SBC before a vehicle time, s, in words; empty: there was none.
std::string outagesBefore(const HeardMission& heard, double vehicle_time);

}  // namespace glider::flights
