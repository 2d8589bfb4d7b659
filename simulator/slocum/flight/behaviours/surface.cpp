// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/surface.h"

#include <cmath>
#include <limits>

namespace glider::simulator {

constexpr double kNotYet = std::numeric_limits<double>::quiet_NaN();

Surface::Surface(const BehaviourSource& source)
    : StartedBehaviour(source),
      end_action_(static_cast<EndAction>(source.code("end_action"))),
      pitch_(source.pitch("c_")),
      pump_cc_(source.pump("c_", BehaviourSource::Pumps::Out)),
      gps_wait_s_(source.argument("gps_wait_time")),
      keystroke_wait_s_(source.argument("keystroke_wait_time")),
      end_distance_m_(source.argument("end_wpt_dist")) {}

bool Surface::waitsForKeys() const {
  return end_action_ == EndAction::WaitThenResume || end_action_ == EndAction::WaitThenQuit ||
         (end_action_ == EndAction::WaitOnce && !has_waited_);
}

/// The fix is there, or will not come.
bool Surface::dialogueOver(const Situation& s) const {
  if (end_action_ == EndAction::DriftAway) {
    return s.waypoint_distance_m > end_distance_m_();
  }
  return s.time_s - fixed_s_ >= (waitsForKeys() ? keystroke_wait_s_() : 0);
}

void Surface::begin(const Situation& situation) {
  StartedBehaviour::begin(situation);
  surfaced_s_ = kNotYet;
  fixed_s_ = kNotYet;
}

Behaviour::Outcome Surface::fly(const Situation& s, Commands& commands) {
  // Also commands in its last cycle: at the surface there may be no lower behaviour to take over.
  commands.point(pitch_.now());
  commands.pump(pump_cc_());
  if (!commands.heading) {
    commands.steer({HeadingCommand::Mode::Fin, 0, 0, 0});
  }
  if (std::isnan(surfaced_s_) && s.at_surface) {
    surfaced_s_ = s.time_s;
  }
  if (std::isnan(surfaced_s_)) {
    return Outcome::Continue;
  }
  const bool fixed = s.gps_fix || s.time_s - surfaced_s_ >= gps_wait_s_();
  if (std::isnan(fixed_s_) && fixed) {
    fixed_s_ = s.time_s;
  }
  // After the fix, or the wait for one, the vehicle calls: it has contact while it is up.
  if (!std::isnan(fixed_s_) && s.at_surface) {
    contact_s_ = s.time_s;
  }
  if (std::isnan(fixed_s_) || !dialogueOver(s)) {
    return Outcome::Continue;
  }
  has_waited_ = true;
  return Outcome::Done;
}

}  // namespace glider::simulator
