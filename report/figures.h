// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace glider::report {

/// How long a state was current.
struct StateFigures {
  double id = 0;  ///< as in the column "state"
  std::string name;
  size_t visits = 0;  ///< entries, a return into the state included
  double time_s = 0;
};

/// Where the distance over ground was taken from.
enum class TrackSource : unsigned char { None, True, DeadReckoned };

/// What a flight comes to in a few numbers. NaN (or an empty list) where the trace has no column
/// for it.
struct FlightFigures {
  size_t rows = 0;
  double duration_s = 0;
  double shallowest_m = 0;
  double deepest_m = 0;
  size_t yos = 0;          ///< dives of at least kYoDepth followed by a climb of at least kYoDepth
  double distance_m = 0;   ///< over ground, along the track
  double made_good_m = 0;  ///< straight from the first position to the last
  TrackSource track = TrackSource::None;
  double coldest_degC = 0;
  double warmest_degC = 0;
  std::vector<StateFigures> states;  ///< those that were entered, in the mission's order
  double layered_s = 0;              ///< time in which the vehicle's layered control decided
  double stateless_s =
      0;  ///< time in which the SBC was in control without a state: a mission written in C
  std::map<std::string, size_t> events;  ///< count by kind
};

/// The least change of depth that counts as a leg of a yo: above a pressure sensor's noise and a
/// surface wave.
inline constexpr double kYoDepth = 2.0;

/// The figures of `trace`. A row holds until the next row's time; the last one holds for no time.
FlightFigures flightFigures(const support::Trace& trace);
/// The same as a JSON object; NaN is null.
std::string figuresToJson(const FlightFigures& figures);

/// Where a dive turned into a climb, or a climb into a dive.
struct TurningPoint {
  size_t row = 0;
  bool at_bottom = false;
};

/// The turning points of the depth, with at least kYoDepth of change on both sides; the first may
/// be the start.
std::vector<TurningPoint> turningPoints(const support::Trace& trace);

/// The column that the report calls depth: m_depth, else true_depth, else -1.
int depthColumn(const support::Trace& trace);
/// The name of state number `id` of the column "state"; `state 7` for one that the trace does not
/// name.
std::string stateName(const support::Trace& trace, double id);

}  // namespace glider::report
