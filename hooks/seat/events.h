// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/messages.h"

#include <stdint.h>

namespace glider::hooks {

/// Events for the vehicle's log or the simulator's trace.
struct SeatEvent {
  enum class Kind : uint8_t {
    None,
    SbcHello,  ///< a link: a = its number; text = the mission's name
    SbcLost,   ///< no answer for 12 s, or the line closed, before its mission finished: a = the
               ///< link's number
    SbcStuck,  ///< it answers, but its mission time has not advanced for 12 s while it is in
               ///< control: a = its session
    SbcUnanswered,  ///< the vehicle has not answered an instruction for 12 s: a = its sequence
    SbcTransition,  ///< a = Transition of notices.h, b from, c to, d fired case, e its CaseList
    SbcNote,        ///< a note from the mission: a = its kind (NoteKind); text
    BadFrame,       ///< a = frames discarded on all its lines since the last such event
    SbcRefused,     ///< speaks another protocol (a = its version), has another sensor dictionary (b
                    ///< = its hash), or one side lacks features that the other needs (c)
    RefusedWrite,   ///< the SBC tried to write sensor a, which is not the hook's; nothing of that
                    ///< frame was written
    OldInstruction,  ///< the vehicle refuses a repeated instruction: a = its sequence
    StaleFrame,  ///< a = frames of the SBC and reports of the vehicle, since the last finish, that
                 ///< are ignored because their time is earlier than one reported before
  } kind = Kind::None;
  double mission_time_s =
      0;  ///< SbcTransition, SbcNote: the mission's own; else m_present_secs_into_mission
  uint32_t a = 0, b = 0, c = 0, d = 0, e = 0;
  char text[kMostNoteBytes + 1] = {};
  static_assert(kMostNameBytes <= kMostNoteBytes);
};

/// Events that wait to be taken. Newer ones that do not fit are dropped, notes before others.
class EventQueue {
 public:
  void push(const SeatEvent& event);
  /// Takes the oldest; Kind::None when there is none.
  SeatEvent next();

 private:
  static constexpr uint32_t kMost = 32;
  /// Notes leave this much room for what matters more.
  static constexpr uint32_t kRoomBesideNotes = 16;

  SeatEvent events_[kMost];
  uint32_t first_ = 0;
  uint32_t count_ = 0;
};

}  // namespace glider::hooks
