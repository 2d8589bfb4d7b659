// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/seat.h"

#include "hooks/protocol/c_library.h"
#include "hooks/protocol/numbers.h"
#include "hooks/seat/handle.h"

void hookSeatInit(HookSeat* seat, const GliderDictionary* dictionary,
                  const HookSeatOptions* options) {
  memset(seat, 0, sizeof *seat);
  seat->dictionary = dictionary;
  seat->options = *options;
  hookReporterInit(&seat->reporter, dictionary);
  hookProgressWatchInit(&seat->progress);
}

void hookSeatTell(HookSeat* seat, HookSeatEventKind kind, uint32_t a, uint32_t b, uint32_t c) {
  HookSeatEvent told;
  memset(&told, 0, sizeof told);
  told.kind = kind;
  told.mission_time_s = seat->state.vehicle_time_s;
  told.a = a;
  told.b = b;
  told.c = c;
  hookEventQueuePush(&seat->events, &told);
}

void hookSeatForgetView(HookSeat* seat) {
  memset(&seat->view, 0, sizeof seat->view);
}

void hookSeatSend(HookSeat* seat, HookFrame* frame) {
  frame->sequence = ++seat->out_sequence;
  // No room: the line is not being read; the next cycle brings newer values.
  (void)hookSendQueueAdd(&seat->out, frame);
}

void hookSeatFeatures(const HookSeat* seat, HookFeatures* features) {
  const uint16_t time = seat->options.virtual_time ? kHookFeatureVirtualTime : 0;
  features->offers = (uint16_t)(time | seat->options.obeys);
  features->needs = time;
}

/// The numbers begin at a different value each time that the vehicle's computer starts. A first
/// frame or heartbeat equal to the last one before the restart would be taken for a repetition of
/// it.
static void beginNumbers(HookSeat* seat) {
  // Up to the year 2106.
  const double seconds = hookAtMost(hookAtLeast(seat->now_s, 0), UINT32_MAX);
  const uint32_t whole = (uint32_t)seconds % kHookMostSession;
  seat->out_sequence = (uint8_t)whole;
  seat->heartbeat = whole;
  seat->started = true;
}

static void loseSbc(HookSeat* seat) {
  if (seat->view.phase != kHookMissionPhaseFinished) {  // after that it may leave without an alarm
    hookSeatTell(seat, kHookSeatEventKindSbcLost, seat->link, 0, 0);
  }
  seat->link = 0;
  seat->waiting = false;
  hookNapsReset(&seat->naps);
  hookSeatForgetView(seat);
}

bool hookSeatWantsSbc(const HookSeat* seat) {
  return !seat->naps.asleep;
}

void hookSeatServe(HookSeat* seat, double now_s, const HookSeatState* state,
                   const HookSeatVehicle* vehicle, const GliderByteStream* sbc) {
  seat->now_s = now_s;
  seat->state = *state;
  seat->vehicle = vehicle;
  if (!seat->started) {
    beginNumbers(seat);
  }
  // Bounded: an SBC that never stops sending must not keep the vehicle's computer from its other
  // work.
  for (int frames = 0; frames < 64; ++frames) {
    const HookFrameReading result = hookFrameReaderNext(&seat->reader, sbc);
    if (result == kHookFrameReadingClosed && seat->link != 0) {
      loseSbc(seat);
    }
    if (result != kHookFrameReadingFrame) {
      break;
    }
    hookSeatHandle(seat, &seat->reader.decoder.frame);
  }
  seat->vehicle = NULL;
}

void hookSeatWatch(HookSeat* seat, const HookSeatState* state) {
  seat->state = *state;
  hookAnswerWatchAnswered(&seat->answers, state->answered_sequence);
  if (hookAnswerWatchIsOverdue(&seat->answers, kHookSeatUnansweredSecs, seat->now_s)) {
    hookSeatTell(seat, kHookSeatEventKindSbcUnanswered, seat->answers.instruction, 0, 0);
  }
  const bool old = state->answer == kHookAnswerOldSequence;
  const uint32_t refused = old ? state->answered_sequence : 0;
  if (old && refused != seat->old_told) {
    hookSeatTell(seat, kHookSeatEventKindOldInstruction, refused, 0, 0);
  }
  seat->old_told = refused;
}

static void sendBeacon(HookSeat* seat) {
  HookBeacon beacon;
  beacon.version = kHookProtocolVersion;
  hookSeatFeatures(seat, &beacon.features);
  beacon.dictionary = seat->dictionary->hash;
  beacon.hook_state = seat->state.hook_state;
  HookFrame frame;
  hookEncodeBeacon(&beacon, &frame);
  hookSeatSend(seat, &frame);
}

static void fillTickHead(const HookSeat* seat, HookTickHead* head) {
  head->virtual_time = seat->options.virtual_time;
  head->kept = false;  // known only when it is sent
  head->link = seat->link;
  head->vehicle_time_s = seat->state.vehicle_time_s;
  head->cycle = seat->state.cycle;
  head->subscription = seat->reporter.check;
  head->hook_state = seat->state.hook_state;
  head->answer = seat->state.answer;
  head->answered_sequence = (uint16_t)seat->state.answered_sequence;
  head->session = seat->state.session;
  head->clock_s = seat->state.clock_s;
}

/// The Tick of this cycle, without a number.
static void composeTick(HookSeat* seat, const HookSeatVehicle* vehicle, const HookTickHead* head,
                        HookFrame* frame) {
  HookReporter* reporter = &seat->reporter;
  hookReporterBegin(reporter);
  const HookSubscribe* subscribed = &reporter->subscription;
  for (uint32_t i = 0; i < subscribed->count; ++i) {
    double value = 0;
    if (vehicle->reading(vehicle->self, subscribed->sensors[i].id, &value)) {
      hookReporterReport(reporter, i, value);
    }
  }
  hookEncodeTick(seat->dictionary, head, subscribed, &reporter->readings, frame);
}

void hookSeatWaitForAnswer(HookSeat* seat) {
  if (!seat->waiting) {
    seat->waiting = true;
    hookSinceBegin(&seat->waits, seat->now_s);
  }
}

static void sendTick(HookSeat* seat, HookFrame* frame) {
  hookSeatSend(seat, frame);
  hookReporterSent(&seat->reporter, frame->sequence);
  hookSeatWaitForAnswer(seat);
}

void hookSeatTick(HookSeat* seat, const HookSeatState* state, const HookSeatVehicle* vehicle) {
  seat->state = *state;
  if (seat->link == 0) {
    sendBeacon(seat);
    return;
  }
  HookTickHead head;
  HookFrame frame;
  fillTickHead(seat, &head);
  composeTick(seat, vehicle, &head, &frame);
  seat->naps.ordered = false;
  if (hookNapsKeep(&seat->naps)) {
    hookSeatKeepTick(seat, &head, &frame);
  } else {
    sendTick(seat, &frame);
  }
  if (!seat->naps.asleep) {
    seat->naps.start = head;
  }
  hookSeatBeatInItsPlace(seat, vehicle);
}

void hookSeatPassOverStaleReport(HookSeat* seat) {
  ++seat->stale;
}

static void countBadFrames(HookSeat* seat, uint32_t of_vehicle) {
  const uint32_t bad = seat->reader.decoder.bad_frames + of_vehicle + seat->malformed;
  if (bad != seat->bad_frames_told) {
    hookSeatTell(seat, kHookSeatEventKindBadFrame, bad - seat->bad_frames_told, 0, 0);
    seat->bad_frames_told = bad;
  }
  if (seat->stale != 0) {
    hookSeatTell(seat, kHookSeatEventKindStaleFrame, seat->stale, 0, 0);
    seat->stale = 0;
  }
}

void hookSeatFinish(HookSeat* seat, const GliderByteStream* sbc, uint32_t bad_frames) {
  const bool open = hookSeatSendAll(seat, sbc);
  if (seat->link != 0 && (!open || (seat->waiting && hookSinceLasts(&seat->waits, seat->now_s) >=
                                                         (double)kHookSeatLostSecs))) {
    loseSbc(seat);
  }
  countBadFrames(seat, bad_frames);
}

bool hookSeatNextEvent(HookSeat* seat, HookSeatEvent* event) {
  return hookEventQueueNext(&seat->events, event);
}
