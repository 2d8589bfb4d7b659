// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/tick_ring.h"

static void put(HookTickRing* ring, uint8_t byte) {
  ring->bytes[(ring->first + ring->used) % kHookTickRingBytes] = byte;
  ++ring->used;
}

static uint8_t at(const HookTickRing* ring, uint32_t place) {
  return ring->bytes[(ring->first + place) % kHookTickRingBytes];
}

/// Of the oldest Tick's payload.
static uint32_t oldestSize(const HookTickRing* ring) {
  const uint32_t size = at(ring, 2) | (uint32_t)at(ring, 3) << 8U;
  return size < kHookMostPayload ? size : kHookMostPayload;
}

bool hookTickRingHasRoom(const HookTickRing* ring, uint32_t ticks, uint32_t payload) {
  return ring->count + ticks <= kHookMostKeptTicks &&
         ring->used + ticks * (kHookTickRingHead + payload) <= kHookTickRingBytes;
}

bool hookTickRingAdd(HookTickRing* ring, const HookFrame* frame) {
  if (!hookTickRingHasRoom(ring, 1, frame->size)) {
    return false;
  }
  put(ring, (uint8_t)frame->type);
  put(ring, frame->sequence);
  put(ring, (uint8_t)frame->size);
  put(ring, (uint8_t)(frame->size >> 8U));
  for (uint32_t i = 0; i < frame->size; ++i) {
    put(ring, frame->payload[i]);
  }
  ++ring->count;
  return true;
}

bool hookTickRingOldest(const HookTickRing* ring, HookFrame* frame) {
  if (ring->count == 0) {
    return false;
  }
  frame->type = at(ring, 0);
  frame->sequence = at(ring, 1);
  frame->size = (uint16_t)oldestSize(ring);
  for (uint32_t i = 0; i < frame->size; ++i) {
    frame->payload[i] = at(ring, kHookTickRingHead + i);
  }
  return true;
}

void hookTickRingDropOldest(HookTickRing* ring) {
  const uint32_t bytes = kHookTickRingHead + oldestSize(ring);
  ring->first = (ring->first + bytes) % kHookTickRingBytes;
  ring->used -= bytes;
  --ring->count;
}

void hookTickRingClear(HookTickRing* ring) {
  ring->first = ring->used = ring->count = 0;
}
