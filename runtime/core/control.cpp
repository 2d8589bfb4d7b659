// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/core/control.h"

#include "hooks/protocol/bounds.h"
#include "runtime/core/assert.h"
#include "runtime/core/instruction.h"

#include <stddef.h>

namespace glider::runtime {

using hooks::HookAnswer;
using hooks::HookControl;
using hooks::HookState;
using Kind = ControlNews::Kind;

ControlNews Control::observe(const hooks::VehicleTick& tick) {
  state_ = tick.hook_state;
  if (standing_ > 0) {
    --standing_;
  }
  if (tick.instruction_sequence != 0) {
    pending_sequence_ = tick.instruction_sequence;
  }
  if (overtaken(tick)) {
    // The answer to the handshake was overtaken by the answer to the next instruction, which was
    // refused: control is ours nevertheless.
    ours_ = true;
    unconfirmed_ = 0;
    pending_ = HookControl::Steer;
    return {Kind::Taken, tick.answered_sequence, HookAnswer::Accepted};
  }
  const ControlNews answer = settlePending(tick);
  return answer.kind != Kind::None ? answer : noticeLoss();
}

bool Control::overtaken(const hooks::VehicleTick& tick) const {
  return !ours_ && pending_ == HookControl::Take && tick.obeys_us &&
         tick.answered_sequence == pending_sequence_ && tick.answer != HookAnswer::None &&
         tick.answer != HookAnswer::Accepted && tick.answer != HookAnswer::BadCheck;
}

ControlNews Control::settlePending(const hooks::VehicleTick& tick) {
  const bool answered = pending_ != HookControl::None && tick.answer != HookAnswer::None &&
                        tick.answered_sequence == pending_sequence_;
  if (!answered) {
    return {};
  }
  if (tick.answer != HookAnswer::Accepted) {
    return refused(tick.answer);
  }
  const HookControl accepted = pending_;
  pending_ = HookControl::None;
  if (accepted != HookControl::Release) {
    accepted_ = instructed_;
    has_accepted_ = true;
  }
  switch (accepted) {
    case HookControl::Take:
      ours_ = true;
      unconfirmed_ = 0;
      return {Kind::Taken, pending_sequence_, tick.answer};
    case HookControl::Release:
      released_ = true;
      return {Kind::Released, pending_sequence_, tick.answer};
    case HookControl::Steer:
    case HookControl::None:
      break;
  }
  return {};
}

ControlNews Control::refused(HookAnswer answer) {
  if (answer == HookAnswer::BadCheck) {
    // Its words come one by one; what is lost the client sends again. It is news only if that takes
    // longer than the vehicle's line.
    constexpr uint8_t kMostTicks = 4;
    if (garbled_ticks_ <= kMostTicks) {
      ++garbled_ticks_;
    }
    return garbled_ticks_ == kMostTicks ? ControlNews{Kind::Refused, pending_sequence_, answer}
                                        : ControlNews{};
  }
  if (pending_ == HookControl::Release) {
    released_ = true;  // no longer ours: there is no control to release
  } else if (pending_ == HookControl::Take) {
    out_of_bounds_ = answer != HookAnswer::WrongSession && answer != HookAnswer::NotReady;
    has_accepted_ = has_accepted_ && !(out_of_bounds_ && sameCommand(instructed_, accepted_));
  }
  pending_ = HookControl::None;
  return {Kind::Refused, pending_sequence_, answer};
}

/// An accepted handshake is trusted until the vehicle's state has had time to contradict it: answer
/// and state may arrive in different frames.
ControlNews Control::noticeLoss() {
  if (!ours_) {
    return {};
  }
  if (state_ == HookState::Active) {
    unconfirmed_ = kConfirmTicks;  // from now on any other state means loss at once
    return {};
  }
  if (unconfirmed_ < kConfirmTicks) {
    ++unconfirmed_;
    return {};
  }
  ours_ = false;
  pending_ = HookControl::None;
  return {Kind::Lost, 0, HookAnswer::None};
}

bool Control::mayTake() const {
  // Active, but not for us: the session is from before this program was restarted.
  return !ours_ &&
         (state_ == HookState::Ready || state_ == HookState::Silent || state_ == HookState::Active);
}

bool Control::choose(const hooks::Instruction& wanted, bool finished, hooks::Instruction& out) {
  if (finished) {
    return chooseRelease(out);
  }
  if (wanted.vertical == hooks::HookVertical::None) {
    return false;
  }
  if (!ours_ && pending_ != HookControl::Take) {
    return chooseTake(wanted, out);
  }
  out = wanted;
  // While the session is still being taken, the client turns this into a handshake.
  out.control = HookControl::Steer;
  return !sameCommand(wanted, instructed_) && !mustWait();
}

/// The words of two instructions that cross the vehicle's line at the same time mix, and hookbeh
/// obeys neither until those of the newer have arrived: of a mission that commands something else
/// on each tick none would be. So an instruction that has replaced one on its way, or has waited
/// for one, stands until it is answered or has had its time.
bool Control::mustWait() const {
  return standing_ > 1 && pending_ != HookControl::None;
}

bool Control::chooseTake(const hooks::Instruction& wanted, hooks::Instruction& out) const {
  const bool hopeless = out_of_bounds_ && sameCommand(wanted, instructed_);
  out = hopeless ? accepted_ : wanted;
  out.control = HookControl::Take;
  return mayTake() && (!hopeless || has_accepted_);
}

bool Control::chooseRelease(hooks::Instruction& out) {
  const bool taken = ours_ || pending_ == HookControl::Take;
  if (!taken || releasing_ticks_ >= kReleaseTicks) {
    released_ = true;
  } else {
    ++releasing_ticks_;
  }
  if (released_ || pending_ == HookControl::Release) {
    return false;
  }
  out = {};
  out.control = HookControl::Release;
  return true;
}

Check Control::brokenPart() const {
  constexpr auto kControls = static_cast<uint16_t>(HookControl::Release);
  constexpr auto kVerticals = static_cast<uint16_t>(hooks::HookVertical::Actuators);
  constexpr auto kLaterals = static_cast<uint16_t>(hooks::HookLateral::Fin);
  // In the order of log/checks.def.
  static constexpr hooks::Bound kBounds[] = {
      {offsetof(Control, state_), static_cast<uint16_t>(HookState::Complete), 1},
      {offsetof(Control, pending_), kControls, 1},
      {offsetof(Control, unconfirmed_), kConfirmTicks, 4},
      {offsetof(Control, releasing_ticks_), kReleaseTicks, 4},
      {offsetof(Control, instructed_.control), kControls, 1},
      {offsetof(Control, instructed_.vertical), kVerticals, 1},
      {offsetof(Control, instructed_.lateral), kLaterals, 1},
      {offsetof(Control, accepted_.control), kControls, 1},
      {offsetof(Control, accepted_.vertical), kVerticals, 1},
      {offsetof(Control, accepted_.lateral), kLaterals, 1},
  };
  constexpr uint32_t kCount = sizeof kBounds / sizeof kBounds[0];
  static_assert(firstOf(Check::HookState, kCount - 1, kCount) == Check::AcceptedLateral);
  return firstOf(Check::HookState, hooks::firstPast(this, kBounds), kCount);
}

void Control::sent(const hooks::Instruction& instruction, uint16_t sequence) {
  const bool takes = instruction.control == HookControl::Take ||
                     (instruction.control == HookControl::Steer && !ours_);
  // Also after one that has stood: this may have waited for it.
  standing_ = standing_ > 0 || pending_ != HookControl::None ? kStandingTicks : 0;
  pending_ = takes ? HookControl::Take : instruction.control;
  pending_sequence_ = sequence;
  garbled_ticks_ = 0;
  if (instruction.control != HookControl::Release) {
    out_of_bounds_ = false;
    instructed_ = instruction;
  }
}

}  // namespace glider::runtime
