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
  /// Of time in which it was current: a return begins one, `goto` to itself does not.
  size_t stretches = 0;
  double time_s = 0;
};

/// The source of the distance over ground.
enum class TrackSource : unsigned char { None, True, DeadReckoned };

/// What the batteries gave in a flight, and how long they last at this rate.
struct EnergyFigures {
  double used_Wh = 0;
  double known_s = 0;         ///< the time in which a log has records of it
  bool partly_known = false;  ///< that is less than the flight
  double capacity_Wh = 0;     ///< of a full pack; NaN, as what follows: not known
  double to_go_Wh = 0;        ///< in the pack at the end
  double days_left = 0;       ///< at the mean power of that time
  std::vector<support::Consumer> consumers = {};  ///< the greatest first
  std::vector<support::Consumer> at_most = {};    ///< MissionFacts::at_most
  [[nodiscard]] double atMost_Wh() const;         ///< of all; NaN: there is no bound
};

/// A flight summarised in a few numbers. NaN (or an empty list) where the trace has no column for
/// it.
struct FlightFigures {
  size_t rows = 0;
  double duration_s = 0;
  double gaps_s = 0;  ///< the part of it in which a log has no records
  double shallowest_m = 0;
  double deepest_m = 0;
  size_t yos = 0;          ///< dives of at least kYoDepth followed by a climb of at least kYoDepth
  size_t swings = 0;       ///< the same while a hover was in force: no yos
  double distance_m = 0;   ///< over ground, along the track
  double made_good_m = 0;  ///< straight from the first position to the last, by the same positions
  TrackSource track = TrackSource::None;
  double apart_m = 0;  ///< the greatest distance of the dead-reckoned position from the true one
  EnergyFigures energy;
  double coldest_degC = 0;
  double warmest_degC = 0;
  std::vector<StateFigures> states;  ///< those that were entered, in the mission's order
  double layered_s = 0;              ///< time in which the SBC did not command the vehicle
  double stateless_s =
      0;  ///< time in which the SBC was in control without a state: a mission written in C
  size_t sleeps = 0;                     ///< of the SBC
  double asleep_s = 0;                   ///< in them
  bool sleep_saves = true;               ///< BatteryFacts::sleep_saves
  std::map<std::string, size_t> events;  ///< count by kind
};

/// The least change of depth that counts as a leg of a yo: more than a pressure sensor's noise and
/// a surface wave.
inline constexpr double kYoDepth = 2.0;

/// The figures of `trace`. A row is valid until the next row's time; the last one has no duration,
/// and neither has one at the begin of a gap or in it. By dead reckoning, steps by which a GPS fix
/// moved the position belong to no length.
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

/// A dive and the climb after it, by the measured depth.
struct Yo {
  double start_s = 0;
  double duration_s = 0;
  double deepest_m = 0;
  double down_mps = 0;    ///< mean rate of the dive, positive
  double up_mps = 0;      ///< of the climb, positive
  bool surfaced = false;  ///< it ends above support::kSurfaceDepth
};

/// The yos of the flight, in order: as many as FlightFigures::yos. The last one may have only begun
/// to climb.
std::vector<Yo> yosOf(const support::Trace& trace);
/// The same as a JSON array.
std::string yosToJson(const std::vector<Yo>& yos);

/// The column that the report calls depth: m_depth, otherwise true_depth, otherwise -1.
int depthColumn(const support::Trace& trace);
/// The mission, for a log after its vehicle: "comet: SPIRAL.MI".
std::string flightTitle(const support::Trace& trace);
/// The name of state number `id` of the column "state"; `state 7` if the trace does not name it.
std::string stateName(const support::Trace& trace, double id);

}  // namespace glider::report
