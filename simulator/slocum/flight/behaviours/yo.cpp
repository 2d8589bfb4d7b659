// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/yo.h"

namespace glider::simulator {

Yo::Yo(const BehaviourSource& source)
    : StartedBehaviour(source),
      stop_(source.stopCondition()),
      dive_(source, DepthLeg::Direction::Dive, "d_"),
      climb_(source, DepthLeg::Direction::Climb, "c_"),
      begins_(static_cast<Begins>(source.code("start_diving"))),
      half_cycles_to_do_(source.argument("num_half_cycles_to_do")) {}

void Yo::begin(const Situation& situation) {
  StartedBehaviour::begin(situation);
  stop_.restart(situation.time_s);
  half_cycles_ = 0;
  if (begins_ != Begins::Continuing || leg_ == nullptr) {
    leg_ = begins_ == Begins::Climbing ? &climb_ : &dive_;
  }
  leg_->begin(situation);
}

Behaviour::Outcome Yo::fly(const Situation& situation, Commands& commands) {
  if (stop_.met(situation, commands)) {
    return Outcome::Done;
  }
  // A leg whose target is already passed ends in the cycle that began it; two in a row mean that
  // the targets contradict each other, and then the second one flies for one cycle.
  for (int legs = 0; legs < 2 && leg_->over(situation, overridden()); ++legs) {
    ++half_cycles_;
    news_.push_back({EventId::LegOver,
                     {label(), leg_->name(), static_cast<double>(half_cycles_)},
                     leg_->why()});
    if (half_cycles_to_do_() >= 0 && half_cycles_ >= half_cycles_to_do_()) {
      return Outcome::Done;
    }
    leg_ = leg_ == &dive_ ? &climb_ : &dive_;
    leg_->begin(situation);
  }
  leg_->command(commands);
  return Outcome::Continue;
}

void Yo::tell(double time_s, Journal& journal) {
  journal.add(time_s, news_);
}

}  // namespace glider::simulator
