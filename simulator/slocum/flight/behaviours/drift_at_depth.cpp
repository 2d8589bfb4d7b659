// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/drift_at_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::simulator {

// Faster than this the drift is corrected, in either direction.
constexpr double kDrift = 0.02;  // m/s
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostTrim = 100.0;  // cc, on either side of neutral

DriftAtDepth::DriftAtDepth(const BehaviourSource& source)
    : StartedBehaviour(source),
      target_m_(source.argument("target_depth")),
      target_altitude_m_(source.argument("target_altitude")),
      deadband_m_(source.argument("target_deadband")),
      start_distance_m_(source.argument("start_dist_from_target")),
      hover_for_s_(source.argument("stop_when_hover_for")),
      step_cc_(source.argument("bpump_delta_value")),
      delay_s_(source.argument("bpump_delay")),
      pitch_(source.pitch("")),
      dive_(source, DepthLeg::Direction::Dive, "d_"),
      climb_(source, DepthLeg::Direction::Climb, "c_") {}

/// The target depth, or the one at target_altitude above a bottom that is nearer.
void DriftAtDepth::aim(const Situation& s) {
  if (target_altitude_m_() > 0 && std::isfinite(s.altitude_m)) {
    water_m_ = s.depth_m + s.altitude_m;
  }
  const double above_bottom = water_m_ - target_altitude_m_();
  aim_m_ = above_bottom < target_m_() ? std::max(above_bottom, 0.0) : target_m_();
}

bool DriftAtDepth::within(const Situation& s) const {
  const double given = start_distance_m_();
  return std::fabs(s.depth_m - aim_m_) <= (given >= 0 ? given : deadband_m_());
}

void DriftAtDepth::begin(const Situation& s) {
  StartedBehaviour::begin(s);
  hovers_ = false;
  pump_cc_ = 0;
  water_m_ = kUnknown;
  dive_.begin(s), climb_.begin(s);
}

/// A step of the pump against the drift, or towards the depth.
void DriftAtDepth::correct(const Situation& s) {
  if (s.time_s - corrected_s_ < delay_s_()) {
    return;
  }
  corrected_s_ = s.time_s;
  const double off_m = s.depth_m - aim_m_;  // positive: too deep
  const bool sinks = s.depth_rate_mps > kDrift, rises = s.depth_rate_mps < -kDrift;
  const double up = (sinks || (off_m > deadband_m_() && !rises))    ? 1
                    : (rises || (off_m < -deadband_m_() && !sinks)) ? -1
                                                                    : 0;
  pump_cc_ = std::clamp(pump_cc_ + up * step_cc_(), -kMostTrim, kMostTrim);
}

Behaviour::Outcome DriftAtDepth::fly(const Situation& s, Commands& commands) {
  aim(s);
  commands.altimeter = commands.altimeter || target_altitude_m_() > 0;
  if (!hovers_ && within(s)) {
    hovers_ = true;
    hovering_since_s_ = corrected_s_ = s.time_s;
    news_.push_back({EventId::Hovers, {label(), s.depth_m}});
  }
  if (!hovers_) {
    (s.depth_m < aim_m_ ? dive_ : climb_).command(commands);
    return Outcome::Continue;
  }
  if (hover_for_s_() >= 0 && s.time_s - hovering_since_s_ >= hover_for_s_()) {
    return Outcome::Done;
  }
  correct(s);
  commands.point(pitch_.now());
  commands.pump(pump_cc_);
  commands.hovering = true;
  return Outcome::Continue;
}

void DriftAtDepth::tell(double time_s, Journal& journal) {
  journal.add(time_s, news_);
}

}  // namespace glider::simulator
