// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/front_seat/seat_session.h"

namespace glider::runtime {

using hooks::HookAnswer;
using hooks::HookControl;
using hooks::HookState;

/// Without a session. To a program that goes on from a checkpoint, or has steered, the vehicle has
/// lost its SBC: the program decides by the time since then whether it goes on, and only when it
/// asks for control the vehicle is asked. While it waits for that, nothing is asked of it. A
/// program that begins waits for the surface too: it may have seen it before the vehicle's own
/// mission dived.
HookState SeatSession::unheld(const SeatHold& hold) const {
  return hold.taken  ? HookState::Absent
         : !goesOn() ? hold.follows && hold.may_begin ? HookState::Ready : HookState::Waiting
         : hold.follows || !asked_ ? HookState::Silent
                                   : HookState::Waiting;
}

bool SeatSession::follow(const SeatHold& hold) {
  const bool lost = session_ != 0 && !hold.follows && releasing_ == 0;
  if (lost) {
    lost_session_ = session_;
    session_ = 0;
    asked_ = false;
  }
  if (!isOver()) {
    state_ = session_ != 0 ? HookState::Active : unheld(hold);
  }
  return lost;
}

SeatSession::Step SeatSession::take(const hooks::Instruction& instruction, const SeatHold& hold,
                                    HookAnswer within) {
  if (answered_ != 0 && !hookIsNewerSequence(instruction.sequence, answered_)) {
    if (instruction.sequence != answered_) {
      answer_ = HookAnswer::OldSequence;
    }
    return Step::Nothing;
  }
  if (instruction.control == HookControl::Release && session_ != 0 &&
      instruction.session == session_) {
    release_ = instruction.sequence;
    releasing_ = releasing_ == 0 ? 1 : releasing_;
    return Step::Release;
  }
  answered_ = instruction.sequence;
  answer_ = decide(instruction, hold, within);
  return answer_ == HookAnswer::Accepted ? Step::Steer : Step::Nothing;
}

HookAnswer SeatSession::decide(const hooks::Instruction& instruction, const SeatHold& hold,
                               HookAnswer within) {
  const bool takes = instruction.control == HookControl::Take;
  asked_ = asked_ || takes;
  const bool begins = session_ == 0 && !goesOn();
  if (!hold.follows || releasing_ != 0 || isOver() || (begins && !hold.may_begin)) {
    return HookAnswer::NotReady;
  }
  if (takes ? lost_session_ != 0 && !hookIsNewerSession(instruction.session, lost_session_)
            : instruction.session != session_) {
    return HookAnswer::WrongSession;
  }
  if (within == HookAnswer::Accepted) {
    session_ = takes ? instruction.session : session_;
    state_ = HookState::Active;
  }
  return within;
}

void SeatSession::leave() {
  releasing_ = releasing_ == 0 && !isOver() ? 1 : releasing_;
}

void SeatSession::noteRelease(bool has) {
  if (has || ++releasing_ > kReleaseAnswers) {
    releasing_ = 0;
    if (release_ != 0) {
      answered_ = release_;
      answer_ = HookAnswer::Accepted;
    }
    lost_session_ = session_;
    session_ = 0;
    state_ = HookState::Complete;
  }
}

void SeatSession::describe(hooks::SeatState* state) const {
  state->hook_state = state_;
  state->answer = answer_;
  state->answered_sequence = answered_;
  state->session = session_;
}

}  // namespace glider::runtime
