// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_MESSAGES_H
#define GLIDER_HOOKS_PROTOCOL_MESSAGES_H

#include "hooks/protocol/features.h"
#include "hooks/protocol/frame.h"
#include "hooks/protocol/values.h"

/// The messages in frames: one struct, one encoder and one strict decoder per message; Tick and
/// Subscribe are in tick.h, lists of sensors in sensor_list.h. Layouts: README.md. Encoders set the
/// frame's type and payload and leave its sequence alone; decoders return false for a frame of
/// another type, of a wrong length, or with a value that no sender of this protocol writes. The
/// bytes of a text behind its final zero are as they were.
#ifdef __cplusplus
enum class HookMissionPhase : uint8_t {
#define MISSION_PHASE(name, number) name = number,
#include "hooks/protocol/messages.def"
};
#else
typedef uint8_t HookMissionPhase;
enum {
#define MISSION_PHASE(name, number) kHookMissionPhase##name = number,
#include "hooks/protocol/messages.def"
};
#endif

GLIDER_HOOKS_BEGIN

enum { kHookProtocolVersion = 6, kHookMostNameBytes = 47, kHookMostNoteBytes = 60 };

/// From a vehicle without a link: asks an SBC to open one.
typedef struct HookBeacon {
  uint8_t version GLIDER_IS(kHookProtocolVersion);
  HookFeatures features;  ///< the vehicle's
  uint32_t dictionary GLIDER_IS(0);
  HookState hook_state GLIDER_IS(HookState::Absent);
} HookBeacon;

/// The vehicle takes the link of a Hello.
typedef struct HookWelcome {
  bool virtual_time GLIDER_IS(false);
  uint32_t link GLIDER_IS(0);
  /// Newest that was written to the flight controller, 0 for none.
  uint32_t newest_session GLIDER_IS(0);
} HookWelcome;

/// The SBC requests a link.
typedef struct HookHello {
  uint8_t version GLIDER_IS(kHookProtocolVersion);
  HookFeatures features GLIDER_IS(HookFeatures{kHookAllFeatures});  ///< the SBC's
  uint32_t dictionary GLIDER_IS(0);
  uint32_t link GLIDER_IS(0);  ///< 1…kHookMostSession, a different one each time
  char mission_name[kHookMostNameBytes + 1] GLIDER_IS({});
} HookHello;

/// A transition of the mission, reported to the vehicle's side for logs and the simulator's trace.
typedef struct HookTransitionNotice {
  double mission_time_s GLIDER_IS(0);
  uint8_t transition GLIDER_IS(0);  ///< HookTransition
  uint32_t from GLIDER_IS(0);
  uint32_t to GLIDER_IS(0);
  uint32_t fired_case GLIDER_IS(0);  ///< of `always`, or of state `from`
  uint8_t list GLIDER_IS(1);         ///< HookCaseList: which of the two
} HookTransitionNotice;

/// A note from the mission for people: a `log` statement, a value that was unknown.
typedef struct HookMissionNote {
  double mission_time_s GLIDER_IS(0);
  uint8_t kind GLIDER_IS(0);  ///< HookNoteKind
  char text[kHookMostNoteBytes + 1] GLIDER_IS({});
} HookMissionNote;

/// What the heartbeat reports about the mission.
typedef struct HookMissionStatus {
  double mission_time_s GLIDER_IS(0);
  uint32_t state GLIDER_IS(0);
  uint8_t stack_depth GLIDER_IS(0);
  HookMissionPhase phase GLIDER_IS(HookMissionPhase::Waiting);
} HookMissionStatus;

/// Ends the answer to the frame with sequence number `answered`.
typedef struct HookDone {
  uint8_t answered GLIDER_IS(0);
  uint32_t session GLIDER_IS(0);  ///< in which the SBC assumes that it is in control, 0 for none
  HookMissionStatus status;
} HookDone;

void hookEncodeBeacon(const HookBeacon* beacon, HookFrame* frame);
void hookEncodeWelcome(const HookWelcome* welcome, HookFrame* frame);
void hookEncodeHello(const HookHello* hello, HookFrame* frame);
void hookEncodeTransition(const HookTransitionNotice* notice, HookFrame* frame);
void hookEncodeDone(const HookDone* done, HookFrame* frame);
void hookEncodeNote(const HookMissionNote* note, HookFrame* frame);

bool hookDecodeBeacon(const HookFrame* frame, HookBeacon* beacon);
bool hookDecodeWelcome(const HookFrame* frame, HookWelcome* welcome);
bool hookDecodeHello(const HookFrame* frame, HookHello* hello);
bool hookDecodeTransition(const HookFrame* frame, HookTransitionNotice* notice);
bool hookDecodeDone(const HookFrame* frame, HookDone* done);
bool hookDecodeNote(const HookFrame* frame, HookMissionNote* note);

/// True when the SBC owes a Done for this frame: Beacon, Welcome and Tick.
bool hookExpectsAnswer(const HookFrame* frame);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using MissionPhase = HookMissionPhase;
using Beacon = HookBeacon;
using Welcome = HookWelcome;
using Hello = HookHello;
using TransitionNotice = HookTransitionNotice;
using MissionNote = HookMissionNote;
using MissionStatus = HookMissionStatus;
using Done = HookDone;
inline constexpr uint8_t kProtocolVersion = kHookProtocolVersion;
inline constexpr uint32_t kMostNameBytes = kHookMostNameBytes, kMostNoteBytes = kHookMostNoteBytes;

inline void encode(const Beacon& beacon, Frame& frame) {
  hookEncodeBeacon(&beacon, &frame);
}
inline void encode(const Welcome& welcome, Frame& frame) {
  hookEncodeWelcome(&welcome, &frame);
}
inline void encode(const Hello& hello, Frame& frame) {
  hookEncodeHello(&hello, &frame);
}
inline void encode(const TransitionNotice& notice, Frame& frame) {
  hookEncodeTransition(&notice, &frame);
}
inline void encode(const Done& done, Frame& frame) {
  hookEncodeDone(&done, &frame);
}
inline void encode(const MissionNote& note, Frame& frame) {
  hookEncodeNote(&note, &frame);
}

[[nodiscard]] inline bool decode(const Frame& frame, Beacon& beacon) {
  return hookDecodeBeacon(&frame, &beacon);
}
[[nodiscard]] inline bool decode(const Frame& frame, Welcome& welcome) {
  return hookDecodeWelcome(&frame, &welcome);
}
[[nodiscard]] inline bool decode(const Frame& frame, Hello& hello) {
  return hookDecodeHello(&frame, &hello);
}
[[nodiscard]] inline bool decode(const Frame& frame, TransitionNotice& notice) {
  return hookDecodeTransition(&frame, &notice);
}
[[nodiscard]] inline bool decode(const Frame& frame, Done& done) {
  return hookDecodeDone(&frame, &done);
}
[[nodiscard]] inline bool decode(const Frame& frame, MissionNote& note) {
  return hookDecodeNote(&frame, &note);
}

inline bool expectsAnswer(const Frame& frame) {
  return hookExpectsAnswer(&frame);
}
}  // namespace glider::hooks
#endif

#endif
