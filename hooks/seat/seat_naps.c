// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the seat does while its SBC sleeps: protocol/README.md, "Naps".

#include "hooks/seat/handle.h"

/// Bounded, so that a long nap does not keep the vehicle's computer from its other work.
enum { kMostKeptInACall = 64 };

bool hookSeatTakeNap(HookSeat* seat, const HookFrame* frame) {
  HookNap message;
  const bool good = (seat->options.obeys & kHookFeatureNaps) != 0 &&
                    hookDecodeNap(frame, &seat->reporter.subscription, &message);
  seat->naps.ordered = good && seat->waiting && !hookNapsKeep(&seat->naps);
  if (seat->naps.ordered) {
    seat->naps.nap = message;
  }
  return good;
}

void hookSeatBeginNap(HookSeat* seat, const HookDone* done) {
  HookNaps* naps = &seat->naps;
  const bool newest =
      seat->reporter.remembered > 0 && seat->reporter.sequences[0] == done->answered;
  if (naps->ordered && newest && !hookNapsKeep(naps) &&
      seat->state.hook_state == kHookStateActive &&
      hookNapsAllow(&naps->nap, seat->state.nap_secs)) {
    hookNapsBegin(naps, done->session, seat->now_s);
    hookSeatTell(seat, kHookSeatEventKindSbcNap, naps->nap.length_s, naps->nap.count, 0);
  }
}

void hookSeatWake(HookSeat* seat, HookNapEnd why) {
  if (seat->naps.asleep) {
    hookNapsWake(&seat->naps, seat->now_s);
    hookSeatTell(seat, kHookSeatEventKindSbcWoken, why, seat->naps.ring.count, 0);
  }
}

void hookSeatKeepTick(HookSeat* seat, const HookTickHead* head, HookFrame* frame) {
  HookNaps* naps = &seat->naps;
  frame->sequence = ++seat->out_sequence;
  if (hookTickRingAdd(&naps->ring, frame)) {
    hookReporterKept(&seat->reporter, frame->sequence);
  } else {  // the SBC does not read what was kept: as when the line is stuck
    hookReporterSent(&seat->reporter, frame->sequence);
  }
  const HookNapEnd why = naps->asleep
                             ? hookNapsEndBy(naps, head, &seat->reporter, seat->state.nap_secs)
                             : kHookNapEndNone;
  if (why != kHookNapEndNone) {
    hookSeatWake(seat, why);
  }
}

void hookSeatBeatInItsPlace(HookSeat* seat, const HookSeatVehicle* vehicle) {
  const HookNaps* naps = &seat->naps;
  if (naps->beats && seat->state.hook_state == kHookStateActive &&
      seat->state.session == naps->session) {
    hookSeatBeat(seat, vehicle, true);
  }
  if (naps->asleep || naps->waking) {
    hookProgressWatchRest(&seat->progress, seat->now_s);
  }
}

/// Queues the oldest kept Tick. False when none may be sent, or there is no room.
static bool sendKept(HookSeat* seat) {
  HookTickRing* ring = &seat->naps.ring;
  HookFrame frame;
  if (!hookNapsMaySend(&seat->naps, seat->now_s) || !hookTickRingOldest(ring, &frame)) {
    return false;
  }
  hookMarkTickKept(&frame, ring->count > 1);
  if (!hookSendQueueAdd(&seat->out, &frame)) {
    return false;
  }
  hookTickRingDropOldest(ring);
  hookSeatWaitForAnswer(seat);
  return true;
}

bool hookSeatSendAll(HookSeat* seat, const GliderByteStream* sbc) {
  if (hookNapsAreOver(&seat->naps, seat->now_s)) {
    hookSeatWake(seat, kHookNapEndLength);
  }
  bool open = hookSendQueueFlush(&seat->out, sbc);
  uint32_t sent = 0;
  for (bool more = true; open && more && sent < kMostKeptInACall;) {
    const uint32_t before = sent;
    while (sent < kMostKeptInACall && sendKept(seat)) {
      ++sent;
    }
    more = sent > before;
    open = hookSendQueueFlush(&seat->out, sbc);
  }
  return open;
}
