// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/seat/handle.h"

#include "hooks/protocol/c_library.h"

/// No link; reported once for each reason.
static void refuse(HookSeat* seat, const HookHello* hello, uint16_t missing) {
  seat->link = 0;
  hookNapsReset(&seat->naps);
  hookSeatForgetView(seat);
  if (hello->version != seat->refused_version || hello->dictionary != seat->refused_dictionary ||
      missing != seat->refused_features) {
    hookSeatTell(seat, kHookSeatEventKindSbcRefused, hello->version, hello->dictionary, missing);
  }
  seat->refused_version = hello->version;
  seat->refused_dictionary = hello->dictionary;
  seat->refused_features = missing;
}

static void welcome(HookSeat* seat) {
  HookWelcome welcome;
  welcome.virtual_time = seat->options.virtual_time;
  welcome.link = seat->link;
  welcome.newest_session = seat->newest_session;
  HookFrame frame;
  hookEncodeWelcome(&welcome, &frame);
  hookSeatSend(seat, &frame);
}

static void serveNothing(HookSeat* seat) {
  HookSubscribe nothing;
  memset(&nothing, 0, sizeof nothing);
  hookReporterServe(&seat->reporter, &nothing);
}

static void handleHello(HookSeat* seat, const HookHello* hello) {
  HookFeatures features;
  hookSeatFeatures(seat, &features);
  const uint16_t missing = hookMissingFeatures(&features, &hello->features);
  if (hello->version != kHookProtocolVersion || hello->dictionary != seat->dictionary->hash ||
      missing != 0) {
    refuse(seat, hello, missing);
    return;
  }
  seat->refused_version = 0;
  seat->refused_dictionary = 0;
  seat->refused_features = 0;
  seat->link = hello->link;
  seat->told_s = 0;
  seat->waiting = false;
  hookNapsReset(&seat->naps);
  serveNothing(seat);
  HookSeatEvent told;
  memset(&told, 0, sizeof told);
  told.kind = kHookSeatEventKindSbcHello;
  told.mission_time_s = seat->state.vehicle_time_s;
  told.a = seat->link;
  memcpy(told.text, hello->mission_name, kHookMostNameBytes);
  hookEventQueuePush(&seat->events, &told);
  welcome(seat);
}

static void handleWrite(HookSeat* seat, const HookSensorList* list) {
  const GliderDictionary* dictionary = seat->dictionary;
  uint32_t session = seat->newest_session;
  double sequence = 0;
  bool has_sequence = false;
  for (uint32_t i = 0; i < list->count; ++i) {
    const HookSensorValue* value = &list->values[i];
    if (!hookIsInstructionSensor(dictionary, value->id)) {
      hookSeatTell(seat, kHookSeatEventKindRefusedWrite, value->id, 0, 0);
      return;
    }
    if (value->id == hookSensorOf(dictionary, kGliderRoleHookSequence)) {
      sequence = value->value;
      has_sequence = true;
    }
    if (value->id == hookSensorOf(dictionary, kGliderRoleHookSession) && value->value >= 1 &&
        value->value <= (double)kHookMostSession) {
      session = (uint32_t)value->value;
    }
  }
  if (hookIsNewerSession(session, seat->newest_session)) {
    seat->newest_session = session;
  }
  if (has_sequence) {
    // The vehicle refuses a repeated instruction and answers it; the seat does not check for
    // repetitions.
    hookAnswerWatchWritten(&seat->answers, sequence, seat->now_s);
  }
  seat->vehicle->write(seat->vehicle->self, list);
}

/// A mission's time never goes back while it has the link: an earlier time means a repeated
/// message.
static bool isStale(HookSeat* seat, double mission_time_s) {
  const bool stale = mission_time_s < seat->told_s;
  seat->stale += stale ? 1 : 0;
  return stale;
}

static void handleTransition(HookSeat* seat, const HookTransitionNotice* notice) {
  if (isStale(seat, notice->mission_time_s)) {
    return;
  }
  HookSeatEvent told;
  memset(&told, 0, sizeof told);
  told.kind = kHookSeatEventKindSbcTransition;
  told.mission_time_s = notice->mission_time_s;
  told.a = notice->transition;
  told.b = notice->from;
  told.c = notice->to;
  told.d = notice->fired_case;
  told.e = notice->list;
  hookEventQueuePush(&seat->events, &told);
}

static void handleNote(HookSeat* seat, const HookMissionNote* note) {
  if (isStale(seat, note->mission_time_s)) {
    return;
  }
  HookSeatEvent told;
  memset(&told, 0, sizeof told);
  told.kind = kHookSeatEventKindSbcNote;
  told.mission_time_s = note->mission_time_s;
  told.a = note->kind;
  memcpy(told.text, note->text, kHookMostNoteBytes);
  hookEventQueuePush(&seat->events, &told);
}

void hookSeatBeat(HookSeat* seat, const HookSeatVehicle* vehicle, bool asleep) {
  // In a nap all numbers are even, in the next one all are odd: so hookbeh notices that there was a
  // beat of the SBC itself between two naps, also if its line has lost that. At the end of the
  // numbers two of a kind follow each other.
  const uint32_t most = asleep ? 3 : 1;
  for (uint32_t i = 0; i < most; ++i) {
    seat->heartbeat = hookNextSession(seat->heartbeat);
    if (asleep && (seat->heartbeat % 2 == 1) == seat->naps.odd) {
      break;
    }
  }
  vehicle->beat(vehicle->self, seat->heartbeat, asleep);
}

/// True if the time of the mission in control has advanced.
static bool noteProgress(HookSeat* seat, const HookDone* done) {
  if (hookProgressWatchHasGoneOn(&seat->progress, done->session, done->status.mission_time_s,
                                 seat->now_s)) {
    return true;
  }
  if (seat->state.session != 0 &&
      hookProgressWatchIsStuck(&seat->progress, kHookSeatLostSecs, seat->now_s)) {
    hookSeatTell(seat, kHookSeatEventKindSbcStuck, done->session, 0, 0);
  }
  return false;
}

/// A program answers; whether it is alive, and the one that steers.
static void followHeartbeat(HookSeat* seat, const HookDone* done) {
  // A restarted program also answers, but it does not steer what its predecessor started: only the
  // answers of the session in control keep that session alive. They do not if the mission's time
  // does not advance: then a program answers, but no mission runs.
  const uint32_t in_control = seat->state.session;
  // A program that is not in control yet has already reported its time, so that a repetition of it
  // is not progress.
  const bool counts = done->session != 0 && (in_control == 0 || done->session == in_control);
  const bool alive = counts ? noteProgress(seat, done) : in_control == 0;
  if (alive) {
    hookSeatBeat(seat, seat->vehicle, false);
  }
  if (alive && counts && in_control != 0) {
    hookSeatBeginNap(seat, done);
  }
}

static void handleDone(HookSeat* seat, const HookDone* done) {
  if (isStale(seat, done->status.mission_time_s)) {
    return;
  }
  seat->told_s = done->status.mission_time_s;
  seat->waiting = false;
  hookReporterAnswered(&seat->reporter, done->answered);
  seat->view.known = true;
  seat->view.mission_time_s = done->status.mission_time_s;
  seat->view.state = done->status.state;
  seat->view.stack_depth = done->status.stack_depth;
  seat->view.phase = done->status.phase;
  // While nothing is sent, this is the answer to something earlier.
  seat->naps.beats = seat->naps.beats && (seat->naps.asleep || seat->naps.waking);
  followHeartbeat(seat, done);
}

static bool takeHello(HookSeat* seat, const HookFrame* frame) {
  HookHello message;
  memset(&message, 0, sizeof message);         // its text goes on whole
  message.features.offers = kHookAllFeatures;  // of another version they are not known
  const bool good = hookDecodeHello(frame, &message);
  if (good) {
    handleHello(seat, &message);
  }
  return good;
}

static bool takeSubscribe(HookSeat* seat, const HookFrame* frame) {
  HookSubscribe message;
  memset(&message, 0, sizeof message);
  const bool good = hookDecodeSubscribe(seat->dictionary, frame, &message);
  if (good) {
    hookReporterServe(&seat->reporter, &message);
  }
  return good;
}

static bool takeTransition(HookSeat* seat, const HookFrame* frame) {
  HookTransitionNotice message;
  const bool good = hookDecodeTransition(frame, &message);
  if (good) {
    handleTransition(seat, &message);
  }
  return good;
}

static bool takeNote(HookSeat* seat, const HookFrame* frame) {
  HookMissionNote message;
  memset(&message, 0, sizeof message);  // its text goes on whole
  const bool good = hookDecodeNote(frame, &message);
  if (good) {
    handleNote(seat, &message);
  }
  return good;
}

static bool takeDone(HookSeat* seat, const HookFrame* frame) {
  HookDone message;
  const bool good = hookDecodeDone(frame, &message);
  if (good) {
    handleDone(seat, &message);
  }
  return good;
}

static bool takeWrite(HookSeat* seat, const HookFrame* frame) {
  HookSensorList message;
  const bool good = hookDecodeList(seat->dictionary, frame, &message);
  if (good) {
    handleWrite(seat, &message);
  }
  return good;
}

/// False when the frame is not a good one of those that an SBC with a link sends.
static bool handleOfLink(HookSeat* seat, const HookFrame* frame) {
  switch (frame->type) {
    case kHookMessageTypeSubscribe:
      return takeSubscribe(seat, frame);
    case kHookMessageTypeTransition:
      return takeTransition(seat, frame);
    case kHookMessageTypeNote:
      return takeNote(seat, frame);
    case kHookMessageTypeDone:
      return takeDone(seat, frame);
    case kHookMessageTypeWrite:
      return takeWrite(seat, frame);
    case kHookMessageTypeNap:
      return hookSeatTakeNap(seat, frame);
    default:
      return false;
  }
}

void hookSeatHandle(HookSeat* seat, const HookFrame* frame) {
  const bool slept = seat->naps.asleep;
  const bool good = frame->type == kHookMessageTypeHello ? takeHello(seat, frame)
                    : seat->link == 0 ? true  // the rest of an answer that belongs to no link
                                      : handleOfLink(seat, frame);
  seat->malformed += good ? 0 : 1;
  seat->naps.ordered = seat->naps.ordered && frame->type == kHookMessageTypeNap;
  if (slept && good) {
    hookSeatWake(seat, kHookNapEndFrame);
  }
}
