// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_SEAT_TICK_RING_H
#define GLIDER_HOOKS_SEAT_TICK_RING_H

#include "hooks/protocol/frame.h"

GLIDER_HOOKS_BEGIN

enum {
  kHookTickRingBytes = 16384,
  kHookTickRingHead = 4,  ///< bytes that a Tick takes beside its payload
  /// Ticks: fewer than there are sequence numbers, with those of the newest Ticks before them, so
  /// that an answer belongs to one Tick only.
  kHookMostKeptTicks = 240
};

/// Ticks that are kept while the SBC sleeps: numbered frames, the oldest first. It begins with all
/// bytes zero.
typedef struct HookTickRing {
  uint8_t bytes[kHookTickRingBytes];
  uint32_t first;  ///< where the oldest begins
  uint32_t used;   ///< bytes
  uint32_t count;  ///< Ticks
} HookTickRing;

/// False, with nothing kept, when there is no room for `frame`.
bool hookTickRingAdd(HookTickRing* ring, const HookFrame* frame);
/// Whether so many more Ticks, each with so many bytes of payload, have room.
bool hookTickRingHasRoom(const HookTickRing* ring, uint32_t ticks, uint32_t payload);
/// Copies the oldest Tick to `frame`; it stays in the ring. False when there is none.
bool hookTickRingOldest(const HookTickRing* ring, HookFrame* frame);
/// Removes the oldest, which must be there.
void hookTickRingDropOldest(HookTickRing* ring);
void hookTickRingClear(HookTickRing* ring);

GLIDER_HOOKS_END

#endif
