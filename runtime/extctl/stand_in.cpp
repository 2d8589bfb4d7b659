// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/stand_in.h"

#include "hooks/hookbeh/bounds.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/numbers.h"

namespace glider::runtime::extctl {

using hooks::HookAnswer;
using hooks::HookControl;
using hooks::HookState;

StandIn::StandIn(const GliderPortMission& port, bool may_resume)
    : port_(port), may_resume_(may_resume) {
  bounds_.greatest_depth_m = port.greatest_depth_m;
  bounds_.steepest_pitch_rad = port.steepest_pitch_rad;
  bounds_.shallowest_pitch_rad = port.shallowest_pitch_rad;
}

/// Without a session. A program with a checkpoint decides by the time since then whether this is
/// still its flight: to it the vehicle is Silent, as one that has lost its SBC.
HookState StandIn::stateOf(const VehicleMission& vehicle) const {
  const bool flies = hooks::isFinite(vehicle.time_s) && vehicle.in_glider_dos != 1;
  if (!flies) {
    return HookState::Absent;
  }
  if (hooks::isFinite(vehicle.program)) {
    return vehicle.program == static_cast<double>(port_.program) ? HookState::Ready
                                                                 : HookState::Absent;
  }
  return may_resume_ ? HookState::Silent : HookState::Waiting;
}

void StandIn::observe(const VehicleMission& vehicle) {
  const bool restarted = vehicle.time_s < time_s_;
  time_s_ = hooks::isFinite(vehicle.time_s) ? vehicle.time_s : time_s_;
  const HookState without = stateOf(vehicle);
  const bool over = without == HookState::Absent;
  if (restarted || over) {
    loseSession();
    releasing_ = 0;
    state_ = without;
  } else if (releasing_ != 0) {
    finishRelease();
  } else if (state_ != HookState::Complete) {
    state_ = session_ != 0 ? HookState::Active : without;
  }
}

void StandIn::finishRelease() {
  if (++releasing_ > kReleaseCycles) {
    releasing_ = 0;
    answered_ = release_;
    answer_ = HookAnswer::Accepted;
    loseSession();
    state_ = HookState::Complete;
  }
}

void StandIn::loseSession() {
  lost_session_ = session_ != 0 ? session_ : lost_session_;
  session_ = 0;
}

void StandIn::instruct(const hooks::Instruction& instruction) {
  if (answered_ != 0 && !hooks::isNewerSequence(instruction.sequence, answered_)) {
    if (instruction.sequence != answered_) {
      answer_ = HookAnswer::OldSequence;
    }
    return;
  }
  if (isRelease(instruction)) {
    release_ = instruction.sequence;
    releasing_ = releasing_ == 0 ? 1 : releasing_;
    return;
  }
  answered_ = instruction.sequence;
  answer_ = decide(instruction);
}

bool StandIn::isRelease(const hooks::Instruction& instruction) const {
  return instruction.control == HookControl::Release && session_ != 0 &&
         instruction.session == session_;
}

HookAnswer StandIn::decide(const hooks::Instruction& instruction) {
  const bool takes = instruction.control == HookControl::Take;
  if (state_ == HookState::Absent || state_ == HookState::Waiting || released()) {
    return HookAnswer::NotReady;
  }
  if (takes ? lost_session_ != 0 && !hooks::isNewerSession(instruction.session, lost_session_)
            : instruction.session != session_) {
    return HookAnswer::WrongSession;
  }
  if (instruction.vertical == hooks::HookVertical::Hover ||
      instruction.vertical == hooks::HookVertical::None ||
      instruction.lateral == hooks::HookLateral::Fin) {
    return HookAnswer::BadCommand;  // no stock behaviour that the port can start does this
  }
  const HookAnswer within = hooks::checkBounds(instruction, bounds_);
  if (within != HookAnswer::Accepted) {
    return within;
  }
  command_ = instruction;
  has_command_ = true;
  session_ = takes ? instruction.session : session_;
  state_ = HookState::Active;
  return HookAnswer::Accepted;
}

}  // namespace glider::runtime::extctl
