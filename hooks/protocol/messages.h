// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/features.h"
#include "hooks/protocol/frame.h"
#include "hooks/protocol/values.h"

#include <stdint.h>

/// The messages in frames: one struct, one encoder and one strict decoder per message; Tick and
/// Subscribe are in tick.h, lists of sensors in sensor_list.h. Layouts: README.md. Encoders set the
/// frame's type and payload and leave its sequence alone; decoders return false for a frame of
/// another type, of a wrong length, or with a value that no sender of this protocol writes.
namespace glider::hooks {

inline constexpr uint8_t kProtocolVersion = 6;
inline constexpr uint32_t kMostNameBytes = 47;
inline constexpr uint32_t kMostNoteBytes = 60;

/// From a vehicle without a link: asks an SBC to open one.
struct Beacon {
  uint8_t version = kProtocolVersion;
  Features features;  ///< the vehicle's
  uint32_t dictionary = 0;
  HookState hook_state = HookState::Absent;
};

/// The vehicle takes the link of a Hello.
struct Welcome {
  bool virtual_time = false;
  uint32_t link = 0;
  uint32_t newest_session = 0;  ///< newest that was written to the flight controller, 0 for none
};

/// The SBC requests a link.
struct Hello {
  uint8_t version = kProtocolVersion;
  Features features = {.offers = kAllFeatures, .needs = 0};  ///< the SBC's
  uint32_t dictionary = 0;
  uint32_t link = 0;  ///< 1…kMostSession, a different one each time
  char mission_name[kMostNameBytes + 1] = {};
};

/// A transition of the mission, reported to the vehicle's side for logs and the simulator's trace.
struct TransitionNotice {
  double mission_time_s = 0;
  uint8_t transition = 0;  ///< Transition of notices.h
  uint32_t from = 0;
  uint32_t to = 0;
  uint32_t fired_case = 0;  ///< of `always`, or of state `from`
  uint8_t list = 1;         ///< CaseList of notices.h: which of the two
};

/// A note from the mission for people: a `log` statement, a value that was unknown.
struct MissionNote {
  double mission_time_s = 0;
  uint8_t kind = 0;  ///< NoteKind of notices.h
  char text[kMostNoteBytes + 1] = {};
};

/// The progress of the SBC's mission.
enum class MissionPhase : uint8_t { Waiting = 0, Flying = 1, Finished = 2 };

/// What the heartbeat reports about the mission.
struct MissionStatus {
  double mission_time_s = 0;
  uint32_t state = 0;
  uint8_t stack_depth = 0;
  MissionPhase phase = MissionPhase::Waiting;
};

/// Ends the answer to the frame with sequence number `answered`.
struct Done {
  uint8_t answered = 0;
  uint32_t session = 0;  ///< in which the SBC assumes that it is in control, 0 for none
  MissionStatus status;
};

void encode(const Beacon& beacon, Frame& frame);
void encode(const Welcome& welcome, Frame& frame);
void encode(const Hello& hello, Frame& frame);
void encode(const TransitionNotice& notice, Frame& frame);
void encode(const Done& done, Frame& frame);
void encode(const MissionNote& note, Frame& frame);

[[nodiscard]] bool decode(const Frame& frame, Beacon& beacon);
[[nodiscard]] bool decode(const Frame& frame, Welcome& welcome);
[[nodiscard]] bool decode(const Frame& frame, Hello& hello);
[[nodiscard]] bool decode(const Frame& frame, TransitionNotice& notice);
[[nodiscard]] bool decode(const Frame& frame, Done& done);
[[nodiscard]] bool decode(const Frame& frame, MissionNote& note);

/// True when the SBC owes a Done for this frame: Beacon, Welcome and Tick.
bool expectsAnswer(const Frame& frame);

}  // namespace glider::hooks
