// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The values that cross the hook, as they are in the vehicle's sensor array. One list for both
/// sides.
namespace glider::hooks {

/// `x_hook_state`: what hookbeh is doing. Absent: the mission file has no hookbeh.
enum class HookState : uint8_t {
  Absent = 0,
  Waiting = 1,   ///< its start condition is not met yet
  Ready = 2,     ///< expects the handshake
  Active = 3,    ///< commands heading, pitch and pump as the SBC instructs
  Silent = 4,    ///< lost the SBC; only a new handshake re-activates it
  Complete = 5,  ///< the SBC released control
};

/// `x_hook_answer`: hookbeh's answer to the instruction with `x_hook_sequence`.
enum class HookAnswer : uint8_t {
  None = 0,
  Accepted = 1,
  BadCheck = 2,      ///< the check value does not match: something was lost on the way
  TooDeep = 3,       ///< beyond the b_arg for greatest depth
  BadPitch = 4,      ///< outside the b_args for pitch
  BadCommand = 5,    ///< an unknown control, vertical or lateral, or a value that is not finite
  NotOnEarth = 6,    ///< the waypoint is not a valid position
  WrongSession = 7,  ///< not from the session in control, or from one that was lost
  NotReady = 8,      ///< hookbeh waits or is complete
  OldSequence = 9,  ///< its number is older than one that was decided on: an instruction sent again
  BadFin = 10,      ///< beyond the b_arg for the fin
  BadPump = 11,     ///< beyond the b_arg for the pump
  BadBattery = 12,  ///< beyond the b_arg for the pitch battery
};

/// Whether a number on the line is a valid one of these values.
inline bool isHookState(uint8_t value) {
  return value <= static_cast<uint8_t>(HookState::Complete);
}
inline bool isHookAnswer(uint8_t value) {
  return value <= static_cast<uint8_t>(HookAnswer::BadBattery);
}

/// `sci_hook_control`.
enum class HookControl : uint8_t {
  None = 0,
  Take = 1,     ///< the handshake: with the first instruction of a new session
  Steer = 2,    ///< a further instruction
  Release = 3,  ///< `exit`: the layered control takes over
};

/// `sci_hook_vertical`.
enum class HookVertical : uint8_t {
  None = 0,
  Descend = 1,
  Ascend = 2,
  Hover = 3,
  Surface = 4,
  Actuators = 5,  ///< pump and pitch battery, in place of depth and pitch
};

/// `sci_hook_lateral`.
enum class HookLateral : uint8_t { Drift = 0, Heading = 1, Waypoint = 2, Fin = 3 };

/// `x_hook_masked`, a sum: which of hookbeh's commands a behaviour above it replaced in the
/// previous cycle.
constexpr uint8_t kMaskedHeading = 1;
constexpr uint8_t kMaskedPitch = 2;
constexpr uint8_t kMaskedPump = 4;

/// The number after `sequence`: counts to 65535, then 1 again.
uint16_t nextSequence(uint16_t sequence);
/// True when `sequence` was given after `other`, wrapping at 65535: at most half the number range
/// (32767) ahead. 0 means none yet: every number is newer.
bool isNewerSequence(uint16_t sequence, uint16_t other);

}  // namespace glider::hooks
