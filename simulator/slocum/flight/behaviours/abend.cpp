// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/abend.h"

#include "simulator/slocum/flight/behaviours/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::simulator {

// A vehicle that moves less than this has stayed at its depth.
constexpr double kSameDepth = 1;  // m

Abend::Abend(const BehaviourSource& source)
    : Behaviour(source.block.name),
      variables_(source.variables),
      overdepth_(source.argument("overdepth")),
      overtime_(source.argument("overtime")),
      undervolts_(source.argument("undervolts")),
      same_depth_for_(source.argument("samedepth_for")),
      waypoint_distance_(source.argument("max_wpt_distance")),
      untickled_for_(source.argument("no_cop_tickle_for")) {}

double Abend::overdepth() const {
  return std::min(overdepth_(), variables_.find(kWorkingDepth).value_or(overdepth_()));
}

void Abend::watchDepth(const Situation& s) {
  if (s.at_surface || !(std::fabs(s.depth_m - reference_depth_) < kSameDepth)) {
    reference_depth_ = s.depth_m;
    reference_since_s_ = s.time_s;
  }
}

Behaviour::Outcome Abend::fly(const Situation& s, Commands& /*commands*/) {
  watchDepth(s);
  const double same_for = s.time_s - reference_since_s_;
  const auto found = [&](Abort abort, std::string why) {
    if (found_ == Abort::None) {
      found_ = abort;
      why_ = std::move(why);
    }
  };
  if (overdepth_() >= 0 && s.depth_m > overdepth()) {
    found(Abort::Overdepth,
          fmt::format("m_depth {:.1f} m > overdepth {} m", s.depth_m, overdepth()));
  }
  if (overtime_() >= 0 && s.time_s > overtime_()) {
    found(Abort::Overtime, fmt::format("{:.0f} s > overtime {} s", s.time_s, overtime_()));
  }
  if (undervolts_() >= 0 && s.voltage < undervolts_()) {
    found(Abort::Undervolts,
          fmt::format("m_battery {:.2f} V < undervolts {} V", s.voltage, undervolts_()));
  }
  if (same_depth_for_() >= 0 && same_for > same_depth_for_()) {
    found(Abort::SameDepth, fmt::format("within {} m of {:.1f} m for {:.0f} s", kSameDepth,
                                        reference_depth_, same_for));
  }
  if (waypoint_distance_() >= 0 && s.waypoint_distance_m > waypoint_distance_()) {
    found(Abort::WaypointTooFar,
          fmt::format("the waypoint is {:.0f} m away", s.waypoint_distance_m));
  }
  if (untickled_for_() >= 0 && s.untickled_s > untickled_for_()) {
    found(Abort::NoTickle, fmt::format("no fix and no contact for {:.0f} s", s.untickled_s));
  }
  return Outcome::Continue;
}

Abort Abend::abort(std::string& why) const {
  why = why_;
  return found_;
}

}  // namespace glider::simulator
