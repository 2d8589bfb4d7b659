// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/flight/behaviours/surface.h"

#include "simulator/flight/behaviours/arguments.h"

#include <cmath>
#include <limits>

namespace glider::simulator {

constexpr double kNotYet = std::numeric_limits<double>::quiet_NaN();

Surface::Surface(const slocum::BehaviourBlock& block)
    : Behaviour(block.name),
      start_(startCondition(block)),
      end_action_(static_cast<int>(block.value("end_action"))),
      pitch_(pitchCommand(block, "c_")),
      pump_cc_(block.value("c_bpump_value")),
      gps_wait_s_(block.value("gps_wait_time")),
      // Only end_action 1 waits for the operator's keys.
      keystroke_wait_s_(end_action_ == 1 ? block.value("keystroke_wait_time") : 0) {}

void Surface::begin(const Situation& situation) {
  start_.noteStart(situation.time_s);
  surfaced_s_ = kNotYet;
  fixed_s_ = kNotYet;
}

Behaviour::Outcome Surface::fly(const Situation& s, Commands& commands) {
  // Also commands in its last cycle: at the surface there may be no lower behaviour to take over.
  commands.point(pitch_);
  commands.pump(pump_cc_);
  if (!commands.heading) {
    commands.steer({HeadingCommand::Mode::Fin, 0, 0, 0});
  }
  if (std::isnan(surfaced_s_) && s.at_surface) {
    surfaced_s_ = s.time_s;
  }
  if (std::isnan(surfaced_s_)) {
    return Outcome::Continue;
  }
  const bool fixed = s.gps_fix || s.time_s - surfaced_s_ >= gps_wait_s_;
  if (std::isnan(fixed_s_) && fixed) {
    fixed_s_ = s.time_s;
  }
  return s.time_s - fixed_s_ >= keystroke_wait_s_ ? Outcome::Done : Outcome::Continue;
}

}  // namespace glider::simulator
