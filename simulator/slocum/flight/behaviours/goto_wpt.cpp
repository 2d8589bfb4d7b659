// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/goto_wpt.h"

#include <utility>

namespace glider::simulator {

GotoWpt::GotoWpt(const BehaviourSource& source)
    : StartedBehaviour(source),
      stop_(source.stopCondition()),
      units_(static_cast<WaypointUnits>(source.code("wpt_units"))),
      x_(source.argument("wpt_x")),
      y_(source.argument("wpt_y")) {}

void GotoWpt::begin(const Situation& s) {
  StartedBehaviour::begin(s);
  stop_.restart(s.time_s);
  fresh_ = true;
}

Behaviour::Outcome GotoWpt::fly(const Situation& s, Commands& commands) {
  // The distance known in the first cycle is still that of the previous waypoint.
  if (!std::exchange(fresh_, false) && stop_.met(s, commands)) {
    commands.hit_waypoint = true;
    return Outcome::Done;
  }
  const WaypointPosition to = s.geography->position(units_, x_(), y_());
  commands.steer({HeadingCommand::Mode::Waypoint, 0, to.latitude_ddmm, to.longitude_ddmm});
  return Outcome::Continue;
}

}  // namespace glider::simulator
