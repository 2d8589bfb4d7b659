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

/// The first violation of `required`, without its number. The interpreter repeats the mission under
/// the requirement's monitor. After an outage both continue with what they knew at the tick of the
/// checkpoint, as the mission does, so that nothing is counted twice that the mission did twice.
/// Ticks that the mission has forgotten are checked too: they have happened.
std::optional<FlownViolation> firstViolation(const ir::Requirement& required,
                                             const KnownFlight& flight);

/// The outages of the SBC before a vehicle time, s, in words; empty: there was none.
std::string outagesBefore(const HeardMission& heard, double vehicle_time);

}  // namespace glider::flights
