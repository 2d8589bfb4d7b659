// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/commands.h"
#include "simulator/slocum/flight/mission_variables.h"
#include "simulator/slocum/flight/situation.h"

#include <string>

namespace glider::simulator {

/// What code 15 of start_when and stop_when means: it differs between releases of the vehicle.
enum class Code15 : uint8_t {
  FarFromWaypoint,  ///< the waypoint is further away than when_wpt_dist
  MissionMode,      ///< a bit of u_mission_mode that is set in when_secs
};

/// The numbers that a condition may need.
struct WhenNumbers {
  Argument secs, distance_m;
  double utc_stamp = -1;    ///< yymmddhhmm
  double inflections = -1;  ///< of the segment since the vehicle was last at the surface
};

/// start_when and stop_when, with the codes of the vehicle.
class WhenCondition {
 public:
  WhenCondition(int code, const WhenNumbers& numbers, Code15 code_15, bool stops = false)
      : code_(code), numbers_(numbers), code_15_(code_15), stops_(stops) {}

  /// True when the condition holds, given what lower behaviours have commanded in this cycle.
  [[nodiscard]] bool met(const Situation& situation, const Commands& below) const;
  /// The code and what it means: "12: no contact for 1200 s"; `below` names the
  /// slots that are idle.
  [[nodiscard]] std::string text(const Commands& below) const;
  void noteStart(double time_s) { started_s_ = time_s, has_started_ = true; }
  void noteEnd(double time_s) { ended_s_ = time_s; }
  /// Counts from now on.
  void restart(double time_s) { started_s_ = ended_s_ = time_s; }

 private:
  [[nodiscard]] std::string meaning(const Commands& below) const;
  [[nodiscard]] bool isMode(const Situation& situation) const;
  [[nodiscard]] bool isTime(const Situation& situation) const;

  int code_;
  WhenNumbers numbers_;
  Code15 code_15_;
  bool stops_;                          ///< a stop_when
  double started_s_ = 0, ended_s_ = 0;  ///< the mission's start counts as the first
  bool has_started_ = false;
};

}  // namespace glider::simulator
