// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "hooks/protocol/values.h"

#include <stdint.h>

/// Taking control of the vehicle, keeping it, and giving it back: which instruction, if any, goes
/// with the answer to a tick. Pure bookkeeping on what the ticks say. The client repeats an
/// instruction until it is answered; here is decided what a refusal means.
namespace glider::runtime {

/// What a tick told of the control, for the log.
struct ControlNews {
  enum class Kind : uint8_t {
    None,
    Taken,     ///< the vehicle does as the mission commands
    Refused,   ///< an instruction was refused: `answer` says why; the one before stays in force
    Lost,      ///< the vehicle no longer listens to this session: it will be taken anew
    Released,  ///< the vehicle has its own control back
  };
  Kind kind = Kind::None;
  uint16_t sequence = 0;
  hooks::HookAnswer answer = hooks::HookAnswer::None;
};

class Control {
 public:
  /// The vehicle's state may come a few ticks after the answer that goes with it.
  static constexpr uint32_t kConfirmTicks = 6;
  /// After so many ticks the vehicle's own time-out is left to take control from a mission that
  /// could not give it back.
  static constexpr uint32_t kGiveBackTicks = 15;

  /// Control is ours already: a program before this one took it, and the vehicle obeys its session.
  void resume() {
    ours_ = true;
    unconfirmed_ = kConfirmTicks;
  }
  /// Control is left to the vehicle for good.
  void release() { released_ = true; }
  /// Takes in a tick: its hook state and its answer.
  ControlNews observe(const hooks::VehicleTick& tick);
  /// True if the vehicle would listen to a handshake now.
  [[nodiscard]] bool mayTake() const;
  /// The instruction for this tick, into `out`; false if there is none to send. `wanted` is the
  /// command in force; a mission that has commanded no vertical yet sends nothing. Where the
  /// vehicle refuses it, control is taken with the last command that it accepted. Once `finished`,
  /// control is given back.
  bool choose(const hooks::Instruction& wanted, bool finished, hooks::Instruction& out);
  /// Must follow a choose() that returned true: the number under which `instruction` was sent.
  void sent(const hooks::Instruction& instruction, uint16_t sequence);
  /// True once a finished mission has nothing left to give back.
  [[nodiscard]] bool released() const { return released_; }

 private:
  [[nodiscard]] bool overtaken(const hooks::VehicleTick& tick) const;
  ControlNews settlePending(const hooks::VehicleTick& tick);
  ControlNews refused(hooks::HookAnswer answer);
  ControlNews noticeLoss();
  bool chooseTake(const hooks::Instruction& wanted, hooks::Instruction& out) const;
  bool chooseGiveBack(hooks::Instruction& out);

  hooks::HookState state_ = hooks::HookState::Absent;
  hooks::Instruction instructed_;  ///< the last command sent
  hooks::Instruction accepted_;    ///< the last that the vehicle took
  bool has_accepted_ = false;
  hooks::HookControl pending_ =
      hooks::HookControl::None;  ///< the instruction that has no answer yet
  uint16_t pending_sequence_ = 0;
  bool garbled_told_ = false;  ///< about the pending one
  bool ours_ = false;          ///< a handshake of ours was accepted
  bool out_of_bounds_ =
      false;  ///< the handshake's command was refused: only another one is worth a new one
  bool released_ = false;
  uint32_t unconfirmed_ =
      0;  ///< ticks since the handshake was accepted without hookbeh being active
  uint32_t giving_back_ = 0;  ///< ticks since control was first given back
};

}  // namespace glider::runtime
