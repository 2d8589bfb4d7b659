// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/depth_behaviour.h"

namespace glider::simulator {

DepthBehaviour::DepthBehaviour(const BehaviourSource& source)
    : StartedBehaviour(source),
      leg_(source,
           source.block.name == "dive_to" ? DepthLeg::Direction::Dive : DepthLeg::Direction::Climb,
           "") {}

void DepthBehaviour::begin(const Situation& s) {
  StartedBehaviour::begin(s);
  leg_.begin(s);
}

Behaviour::Outcome DepthBehaviour::fly(const Situation& s, Commands& commands) {
  if (leg_.over(s, overridden())) {
    why_over_ = leg_.why();
    return Outcome::Done;
  }
  leg_.command(commands);
  return Outcome::Continue;
}

void DepthBehaviour::tell(double time_s, Journal& journal) {
  if (why_over_) {
    journal.add(time_s, EventId::BehaviourOver, {label()}, *why_over_);
    why_over_.reset();
  }
}

}  // namespace glider::simulator
