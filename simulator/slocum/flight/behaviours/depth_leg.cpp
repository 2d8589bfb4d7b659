// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/depth_leg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::simulator {

// A leg that has not gained a metre is stalled.
constexpr double kProgress = 1;  // m

DepthLeg::DepthLeg(const BehaviourSource& source, Direction direction, const std::string& prefix)
    : direction_(direction),
      variables_(source.variables),
      given_depth_(source.argument(prefix + "target_depth")),
      target_altitude_(source.argument(prefix + "target_altitude")),
      pump_cc_(source.pump(prefix, direction == Direction::Dive ? BehaviourSource::Pumps::In
                                                                : BehaviourSource::Pumps::Out)),
      hover_for_s_(source.argument(prefix + "stop_when_hover_for")),
      stalled_for_s_(source.argument(prefix + "stop_when_stalled_for")),
      pitch_(source.pitch(prefix)) {}

double DepthLeg::targetDepth() const {
  const double given = given_depth_();
  return direction_ == Direction::Dive
             ? std::min(given, variables_.find(kWorkingDepth).value_or(given))
             : given;
}

void DepthLeg::begin(const Situation& s) {
  moving_s_ = deepest_s_ = s.time_s;
  best_depth_ = s.depth_m;
}

bool DepthLeg::reached(const Situation& s) {
  const bool dives = direction_ == Direction::Dive;
  const double target = targetDepth();
  if (dives ? s.depth_m >= target : s.depth_m <= target) {
    why_ = fmt::format("m_depth {:.1f} m, target {} m", s.depth_m, target);
    return true;
  }
  const bool past = dives ? s.altitude_m <= target_altitude_() : s.altitude_m >= target_altitude_();
  if (target_altitude_() >= 0 && past) {
    why_ = fmt::format("m_altitude {:.1f} m, target {} m", s.altitude_m, target_altitude_());
    return true;
  }
  return false;
}

bool DepthLeg::stuck(const Situation& s) {
  if (std::fabs(s.depth_rate_mps) >= kHoverRate) {
    moving_s_ = s.time_s;
  }
  const double gain =
      direction_ == Direction::Dive ? s.depth_m - best_depth_ : best_depth_ - s.depth_m;
  if (gain >= kProgress) {
    best_depth_ = s.depth_m;
    deepest_s_ = s.time_s;
  }
  if (hover_for_s_() >= 0 && s.time_s - moving_s_ >= hover_for_s_()) {
    why_ = fmt::format("hovering at {:.1f} m for {} s", s.depth_m, hover_for_s_());
    return true;
  }
  if (stalled_for_s_() >= 0 && s.time_s - deepest_s_ >= stalled_for_s_()) {
    why_ = fmt::format("stalled at {:.1f} m for {} s", s.depth_m, stalled_for_s_());
    return true;
  }
  return false;
}

bool DepthLeg::over(const Situation& s, bool overridden) {
  if (reached(s)) {
    return true;
  }
  if (overridden) {
    begin(s);
    return false;
  }
  return stuck(s);
}

void DepthLeg::command(Commands& commands) const {
  commands.point(pitch_.now());
  commands.pump(pump_cc_());
  commands.altimeter = commands.altimeter || target_altitude_() >= 0;
}

}  // namespace glider::simulator
