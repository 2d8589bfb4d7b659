// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/prepare_to_dive.h"

namespace glider::simulator {
namespace {

const slocum::BehaviourBlock& plainSurface() {
  static const slocum::BehaviourBlock block{"surface", {}, {}};
  return block;
}

BehaviourSource surfaceOf(const BehaviourSource& source) {
  return {plainSurface(), source.hull, source.variables, source.code_15};
}

}  // namespace

PrepareToDive::PrepareToDive(const BehaviourSource& source)
    : StartedBehaviour(source, false),
      wait_s_(source.argument("wait_time")),
      pitch_(surfaceOf(source).pitch("c_")),
      pump_cc_(surfaceOf(source).pump("c_", BehaviourSource::Pumps::Out)) {}

void PrepareToDive::begin(const Situation& s) {
  StartedBehaviour::begin(s);
  begun_s_ = s.time_s;
}

Behaviour::Outcome PrepareToDive::fly(const Situation& s, Commands& commands) {
  if (s.gps_fix || s.time_s - begun_s_ >= wait_s_()) {
    return Outcome::Done;
  }
  commands.point(pitch_.now());
  commands.pump(pump_cc_());
  if (!commands.heading) {
    commands.steer({HeadingCommand::Mode::Fin, 0, 0, 0});
  }
  return Outcome::Continue;
}

}  // namespace glider::simulator
