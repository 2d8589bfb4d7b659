// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_SEAT_EVENTS_H
#define GLIDER_HOOKS_SEAT_EVENTS_H

#include "hooks/protocol/messages.h"

/// Events for the vehicle's log or the simulator's trace: events.def.
#ifdef __cplusplus
enum class HookSeatEventKind : uint8_t {
#define SEAT_EVENT(name) name,
#include "hooks/seat/events.def"
};
#else
typedef uint8_t HookSeatEventKind;
enum {
#define SEAT_EVENT(name) kHookSeatEventKind##name,
#include "hooks/seat/events.def"
};
#endif

GLIDER_HOOKS_BEGIN

typedef struct HookSeatEvent {
#ifdef __cplusplus
  using Kind = HookSeatEventKind;
#endif
  HookSeatEventKind kind GLIDER_IS(HookSeatEventKind::None);
  /// SbcTransition, SbcNote: the mission's own; else m_present_secs_into_mission.
  double mission_time_s GLIDER_IS(0);
  uint32_t a GLIDER_IS(0), b GLIDER_IS(0), c GLIDER_IS(0), d GLIDER_IS(0), e GLIDER_IS(0);
  char text[kHookMostNoteBytes + 1] GLIDER_IS({});
} HookSeatEvent;
GLIDER_STATIC_ASSERT(NamesFitEvents, kHookMostNameBytes <= kHookMostNoteBytes);

enum { kHookMostSeatEvents = 32 };

/// Events that wait to be taken. Newer ones that do not fit are dropped, notes before others. It
/// begins with all bytes zero.
typedef struct HookEventQueue {
  HookSeatEvent events[kHookMostSeatEvents];
  uint32_t first;
  uint32_t count;
} HookEventQueue;

void hookEventQueuePush(HookEventQueue* queue, const HookSeatEvent* event);
/// Takes the oldest. False, and an event without a kind, when there is none.
bool hookEventQueueNext(HookEventQueue* queue, HookSeatEvent* event);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using SeatEvent = HookSeatEvent;
}  // namespace glider::hooks
#endif

#endif
