// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/instruction.h"
#include "hooks/protocol/values.h"
#include "hooks/seat/seat.h"

#include <stdint.h>

namespace glider::runtime {

/// How a vehicle that has another way to be steered stands to the SBC.
struct SeatHold {
  bool follows = false;    ///< the vehicle obeys the SBC
  bool taken = false;      ///< it is in somebody else's hands for as long as the program runs
  bool may_begin = false;  ///< it is where a mission may begin: near the surface
};

/// The control that a mission's program has of such a vehicle, as the hook protocol has it: the
/// handshake, the session, the numbers of instructions, the release. No heap.
class SeatSession {
 public:
  /// What an instruction asks for.
  enum class Step : uint8_t { Nothing, Steer, Release };

  /// `resumes`: the program goes on from a checkpoint.
  explicit SeatSession(bool resumes) : resumes_(resumes) {}

  /// In each cycle, before the program is given it. True if control was lost in it.
  bool follow(const SeatHold& hold);
  /// An instruction whose check value is right; `within`: Accepted, or why the vehicle may not be
  /// given it.
  Step take(const hooks::Instruction& instruction, const SeatHold& hold, hooks::HookAnswer within);
  /// The program ends without releasing control: it is released nevertheless, if there is any.
  void leave();
  /// Of each answer to the vehicle while it releases(): whether it `has` released control. Also
  /// ends after kReleaseAnswers of them.
  void noteRelease(bool has);

  [[nodiscard]] bool releases() const { return releasing_ != 0; }
  /// A session is in force: the vehicle is given the program's commands.
  [[nodiscard]] bool isHeld() const { return session_ != 0; }
  /// The vehicle may be asked for control: the program has just begun, or it has decided to go on.
  [[nodiscard]] bool mayAsk() const { return !isOver() && (asked_ || !goesOn()); }
  /// The program has steered before: it goes on, rather than begins.
  [[nodiscard]] bool goesOn() const { return resumes_ || lost_session_ != 0; }
  /// The program has ended its mission, and control was released.
  [[nodiscard]] bool isOver() const { return state_ == hooks::HookState::Complete; }
  /// Sets what the program is given of it in a cycle.
  void describe(hooks::SeatState* state) const;

  /// So many answers that end the control leave before the program ends.
  static constexpr uint32_t kReleaseAnswers = 60;

 private:
  [[nodiscard]] hooks::HookAnswer decide(const hooks::Instruction& instruction,
                                         const SeatHold& hold, hooks::HookAnswer within);
  [[nodiscard]] hooks::HookState unheld(const SeatHold& hold) const;

  hooks::HookState state_ = hooks::HookState::Absent;
  hooks::HookAnswer answer_ = hooks::HookAnswer::None;
  uint16_t answered_ = 0;
  uint32_t session_ = 0, lost_session_ = 0;
  uint32_t releasing_ =
      0;                  ///< answers since the release was asked for, and this one; 0: it was not
  uint16_t release_ = 0;  ///< its number; 0: the program has not asked for it
  bool resumes_;
  bool asked_ = false;  ///< the program has asked for control since it lost it
};

}  // namespace glider::runtime
