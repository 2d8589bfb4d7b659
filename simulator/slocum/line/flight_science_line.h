// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/line/line_direction.h"

namespace glider::simulator {

/// From the science computer: in 4,205 cycles under water of comet's two logs,
/// `m_science_clothesline_lag` is at most 4.7 s (one in a thousand more than 4.3 s), spread evenly
/// below. A value in twenty waits behind other proglets, up to the 8 s that the platform file
/// promises (`line_lag_s`).
inline constexpr LineLag kLagToFlight{
    .least_s = 0.2, .usual_s = 4.3, .most_s = 8, .waits_share = 0.05};
/// From the flight controller, which has no other program: its report of a cycle, some 37 sensors
/// as text, takes most of a second at 9600 baud.
inline constexpr LineLag kLagToScience{.least_s = 0.2, .usual_s = 1, .most_s = 1, .waits_share = 0};

/// The flight-science link: the vendor's line, which the hooks do not see.
struct FlightScienceLine {
  FlightScienceLine(const Faults& faults, uint64_t seed)
      : to_flight(faults, LineWay::ToFlight, kLagToFlight, seed),
        to_science(faults, LineWay::FromFlight, kLagToScience, seed) {}

  void setNow(double now_s) {
    to_flight.setNow(now_s);
    to_science.setNow(now_s);
  }

  LineDirection to_flight, to_science;
};

}  // namespace glider::simulator
