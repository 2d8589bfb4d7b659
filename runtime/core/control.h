// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "hooks/protocol/instruction.h"
#include "runtime/log/records.h"

#include <stdint.h>

/// Takes, keeps and releases control of the vehicle: decides which instruction, if any, goes with
/// the answer to a tick. It only does bookkeeping on what the ticks report. The client repeats an
/// instruction until it is answered; this class decides what a refusal means.
namespace glider::runtime {

/// What a tick reported about control, for the log.
struct ControlNews {
  enum class Kind : uint8_t {
    None,
    Taken,     ///< the vehicle does as the mission commands
    Refused,   ///< an instruction was refused: `answer` says why; the previous one stays in force
    Lost,      ///< the vehicle no longer obeys this session: control will be taken again
    Released,  ///< control is released
  };
  Kind kind = Kind::None;
  uint16_t sequence = 0;
  hooks::HookAnswer answer = hooks::HookAnswer::None;
};

class Control {
 public:
  /// The vehicle's state may arrive this many ticks after the answer that belongs to it.
  static constexpr uint32_t kConfirmTicks = 6;
  /// If a mission could not release control within this many ticks, the vehicle's own time-out is
  /// left to end it.
  static constexpr uint32_t kReleaseTicks = 15;
  /// An instruction that nothing replaces is obeyed within so many control cycles of the vehicle:
  /// its words cross the vehicle's line in two (platforms/load/longest_lag.h), and the next obeys.
  static constexpr uint32_t kObeyedTicks = 3;
  static constexpr uint32_t kStandingTicks = kObeyedTicks + 1;

  /// Control is ours already: the previous program took it, and the vehicle obeys its session.
  void resume() {
    ours_ = true;
    unconfirmed_ = kConfirmTicks;
    standing_ = kStandingTicks;  // that program's newest instruction may be on its way
  }
  /// Control is left to the vehicle for good.
  void release() { released_ = true; }
  /// Takes in a tick: its hook state and its answer.
  ControlNews observe(const hooks::VehicleTick& tick);
  /// True if the vehicle would accept a handshake now.
  [[nodiscard]] bool mayTake() const;
  /// The instruction for this tick, into `out`; false if there is none to send. `wanted` is the
  /// command in force; a mission that has commanded no vertical yet sends nothing, and one that
  /// changes its command faster than the vehicle obeys sends the newest once it may (mustWait()).
  /// If the vehicle refuses it, control is taken with the last command that it accepted. Once
  /// `finished`, control is released.
  bool choose(const hooks::Instruction& wanted, bool finished, hooks::Instruction& out);
  /// Must follow a choose() that returned true: the number under which `instruction` was sent.
  void sent(const hooks::Instruction& instruction, uint16_t sequence);
  /// True if the vehicle obeys, and no instruction waits for an answer or for its turn.
  [[nodiscard]] bool isSettled() const {
    return ours_ && !released_ && pending_ == hooks::HookControl::None &&
           state_ == hooks::HookState::Active && standing_ <= 1;
  }
  /// True once a finished mission has no control left to release.
  [[nodiscard]] bool released() const { return released_; }
  /// The check that its own memory does not pass; Check::None: it passes all.
  [[nodiscard]] Check brokenPart() const;

 private:
  [[nodiscard]] bool overtaken(const hooks::VehicleTick& tick) const;
  ControlNews settlePending(const hooks::VehicleTick& tick);
  ControlNews refused(hooks::HookAnswer answer);
  ControlNews noticeLoss();
  [[nodiscard]] bool mustWait() const;
  bool chooseTake(const hooks::Instruction& wanted, hooks::Instruction& out) const;
  bool chooseRelease(hooks::Instruction& out);

  hooks::HookState state_ = hooks::HookState::Absent;
  hooks::Instruction instructed_;  ///< the last command sent
  hooks::Instruction accepted_;    ///< the last that the vehicle accepted
  bool has_accepted_ = false;
  hooks::HookControl pending_ =
      hooks::HookControl::None;  ///< the instruction that has no answer yet
  uint16_t pending_sequence_ = 0;
  /// Counts down from kStandingTicks; above 1 the pending one may not be replaced, above 0 the next
  /// that is sent may not be.
  uint32_t standing_ = 0;
  uint8_t garbled_ticks_ = 0;   ///< in which the pending one had not arrived whole
  bool ours_ = false;           ///< a handshake of ours was accepted
  bool out_of_bounds_ = false;  ///< the handshake's command was refused: only a different command
                                ///< justifies a new handshake
  bool released_ = false;
  uint32_t unconfirmed_ =
      0;  ///< ticks since the handshake was accepted without hookbeh being active
  uint32_t releasing_ticks_ = 0;  ///< ticks since release of control was first commanded
};

}  // namespace glider::runtime
