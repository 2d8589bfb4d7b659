// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/flight/behaviour.h"

#include "simulator/flight/behaviours/abend.h"
#include "simulator/flight/behaviours/goto_wpt.h"
#include "simulator/flight/behaviours/hookbeh_adapter.h"
#include "simulator/flight/behaviours/set_heading.h"
#include "simulator/flight/behaviours/surface.h"
#include "simulator/flight/behaviours/yo.h"

namespace glider::simulator {

bool When::met(const Situation& situation, const Commands& below) const {
  switch (code_) {
    case 0:
      return true;
    case 1:
      return below.anyIdle();
    case 2:
      return !below.pitch;
    case 3:
      return !below.heading;
    case 4:
      return !below.pump_cc;
    case 6:
      return situation.time_s - ended_s_ >= secs_;
    case 7:
      return situation.waypoint_distance_m < distance_;
    case 9:
      return situation.time_s - started_s_ >= secs_;
    case 12:
      return situation.silent_s > secs_;
    default:
      return false;  // 5: never
  }
}

void Behaviour::run(const Situation& situation, Commands& commands) {
  if (state_ == State::Waiting && starts(situation, commands)) {
    state_ = State::Active;
    begin(situation);
  }
  if (state_ == State::Active && fly(situation, commands) == Outcome::Done) {
    state_ = resumes() ? State::Waiting : State::Complete;
    ended(situation);
  }
}

std::unique_ptr<Behaviour> makeBehaviour(const slocum::BehaviourBlock& block,
                                         const hooks::Hull& hull) {
  if (block.name == "abend") {
    return std::make_unique<Abend>(block);
  }
  if (block.name == "surface") {
    return std::make_unique<Surface>(block);
  }
  if (block.name == "yo") {
    return std::make_unique<Yo>(block);
  }
  if (block.name == "set_heading") {
    return std::make_unique<SetHeading>(block);
  }
  if (block.name == "goto_wpt") {
    return std::make_unique<GotoWpt>(block);
  }
  if (block.name == "hookbeh") {
    return std::make_unique<HookbehAdapter>(block, hull);
  }
  return nullptr;
}

}  // namespace glider::simulator
