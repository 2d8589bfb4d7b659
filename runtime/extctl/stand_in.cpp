// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/stand_in.h"

#include "hooks/hookbeh/bounds.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/numbers.h"
#include "runtime/core/continuation.h"

namespace glider::runtime::extctl {

using hooks::HookAnswer;
using hooks::HookControl;
using hooks::HookState;

StandIn::StandIn(const GliderPortMission& port, const VehicleMission* last)
    : port_(port), last_(last != nullptr ? *last : VehicleMission{}) {
  bounds_.greatest_depth_m = port.greatest_depth_m;
  bounds_.steepest_pitch_rad = port.steepest_pitch_rad;
  bounds_.shallowest_pitch_rad = port.shallowest_pitch_rad;
}

/// The time of the vehicle's mission and its clock have advanced by the same since the checkpoint:
/// the mission that the program steered then still flies.
bool StandIn::isSameFlight(const VehicleMission& vehicle) const {
  const double by_mission = vehicle.time_s - last_.time_s;
  const double by_clock = vehicle.clock_s - last_.clock_s;
  return by_mission >= 0 && hookMagnitude(by_clock - by_mission) < kSameFlightSecs;
}

/// Without a session. A program that was started again decides by the time since its checkpoint
/// whether it goes on: to it the vehicle is Silent, as one that has lost its SBC.
HookState StandIn::stateOf(const VehicleMission& vehicle) const {
  if (!hookIsFinite(vehicle.time_s) || vehicle.in_glider_dos == 1) {
    return HookState::Absent;
  }
  if (!hookIsFinite(vehicle.program)) {
    return isSameFlight(vehicle) ? HookState::Silent : HookState::Waiting;
  }
  return vehicle.program != static_cast<double>(port_.program) ? HookState::Absent
         : vehicle.time_s < kBeginSecs || makesSafe()          ? HookState::Waiting
                                                               : HookState::Ready;
}

/// By its checkpoint. One that is older than this is of an earlier flight, also to the program.
bool StandIn::goesOn(const VehicleMission& vehicle) const {
  return isSameFlight(vehicle) && vehicle.time_s - last_.time_s < kAnotherFlight;
}

/// Without a session.
void StandIn::lookWhetherSafe(const VehicleMission& vehicle) {
  const bool flies = vehicle.program == static_cast<double>(port_.program) &&
                     vehicle.in_glider_dos != 1 && hookIsFinite(vehicle.time_s);
  const bool unsafe = flies && !knowsStart() && !goesOn(vehicle);
  if (unsafe && told_ && told_s_ != told_s_) {
    told_s_ = vehicle.time_s;
  }
  safe_ = safe_ || (vehicle.at_surface && vehicle.time_s - told_s_ >= kSafeSecs);
  setMakesSafe(unsafe && !safe_);
}

void StandIn::setMakesSafe(bool makes) {
  const double nan = __builtin_nan("");
  comes_up_s_ = !makes ? nan : makes_safe_ ? comes_up_s_ : time_s_;
  comes_up_for_s_ = time_s_ - comes_up_s_;
  makes_safe_ = makes;
  if (!makes) {
    forget();
  }
}

void StandIn::forget() {
  told_ = false;
  told_s_ = __builtin_nan("");
}

/// Of a session. The number of the mission file does not change within a mission: another one is a
/// damaged sentence, which the vehicle would never correct.
bool StandIn::isOver(const VehicleMission& vehicle) const {
  return !hookIsFinite(vehicle.time_s) || vehicle.in_glider_dos == 1 ||
         (session_ == 0 && stateOf(vehicle) == HookState::Absent);
}

void StandIn::observe(const VehicleMission& vehicle, bool answered) {
  const bool restarted = vehicle.time_s < time_s_;
  time_s_ = hookIsFinite(vehicle.time_s) ? vehicle.time_s : time_s_;
  restarted_ = restarted_ || restarted;
  up_since_s_ = !vehicle.at_surface      ? __builtin_nan("")
                : up_since_s_ <= time_s_ ? up_since_s_
                                         : time_s_;
  if (restarted || first_s_ != first_s_) {
    first_s_ = vehicle.time_s;
    safe_ = false;
    setMakesSafe(false);
  }
  if (session_ == 0 && releasing_ == 0 && state_ != HookState::Complete) {
    lookWhetherSafe(vehicle);
  }
  if (restarted || isOver(vehicle)) {
    loseSession();
    releasing_ = 0;
    state_ = stateOf(vehicle);
  } else if (releasing_ != 0) {
    finishRelease(answered);
  } else if (state_ != HookState::Complete) {
    state_ = session_ != 0 ? HookState::Active : stateOf(vehicle);
  }
}

bool StandIn::takeRestart() {
  const bool restarted = restarted_;
  restarted_ = false;
  return restarted;
}

void StandIn::finishRelease(bool answered) {
  releasing_ += answered && releasing_ <= kReleaseCycles ? 1 : 0;
  if (releasing_ > kReleaseCycles && time_s_ - up_since_s_ >= kStaysUpSecs) {
    releasing_ = 0;
    answered_ = release_;
    answer_ = HookAnswer::Accepted;
    loseSession();
    state_ = HookState::Complete;
  }
}

bool StandIn::mayEnd() {
  const bool flies =
      state_ == HookState::Ready || state_ == HookState::Active || state_ == HookState::Silent;
  if (flies && releasing_ == 0) {
    release_ = answered_;
    releasing_ = 1;
  }
  return !flies;
}

void StandIn::loseSession() {
  lost_session_ = session_ != 0 ? session_ : lost_session_;
  session_ = 0;
}

void StandIn::instruct(const hooks::Instruction& instruction) {
  if (answered_ != 0 && !hookIsNewerSequence(instruction.sequence, answered_)) {
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
  if (takes ? lost_session_ != 0 && !hookIsNewerSession(instruction.session, lost_session_)
            : instruction.session != session_) {
    return HookAnswer::WrongSession;
  }
  if (instruction.vertical == hooks::HookVertical::Hover ||
      instruction.vertical == hooks::HookVertical::None ||
      instruction.vertical == hooks::HookVertical::Actuators ||
      instruction.lateral == hooks::HookLateral::Fin) {
    return HookAnswer::BadCommand;  // no stock behaviour that the port can start does this
  }
  const HookAnswer within = hookbehCheckBounds(&instruction, &bounds_);
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
