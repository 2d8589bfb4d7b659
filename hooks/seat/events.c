// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/events.h"

#include "hooks/protocol/c_library.h"

/// Notes leave this much room for what matters more.
enum { kRoomBesideNotes = 16 };

void hookEventQueuePush(HookEventQueue* queue, const HookSeatEvent* event) {
  const bool note = event->kind == kHookSeatEventKindSbcNote;
  if (queue->count < (note ? kHookMostSeatEvents - kRoomBesideNotes : kHookMostSeatEvents)) {
    queue->events[(queue->first + queue->count) % kHookMostSeatEvents] = *event;
    ++queue->count;
  }
}

bool hookEventQueueNext(HookEventQueue* queue, HookSeatEvent* event) {
  if (queue->count == 0) {
    memset(event, 0, sizeof *event);
    return false;
  }
  *event = queue->events[queue->first];
  queue->first = (queue->first + 1) % kHookMostSeatEvents;
  --queue->count;
  return true;
}
