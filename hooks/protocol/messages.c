// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/messages.h"

#include "hooks/protocol/notices.h"
#include "hooks/protocol/numbers.h"
#include "hooks/protocol/payload.h"

enum {
  kMostList = kHookCaseListState,  // of a transition: only these two change the state
  kMostNoteKind = kHookNoteKindUnknownSet
};

static void writeFeatures(HookByteWriter* out, const HookFeatures* features) {
  hookWriteU16(out, features->offers);
  hookWriteU16(out, features->needs);
}

static void readFeatures(HookByteReader* in, HookFeatures* features) {
  features->offers = hookReadU16(in);
  features->needs = hookReadU16(in);
}

/// Its length, then the text, at most `most` bytes of it.
static void writeText(HookByteWriter* out, const char* text, uint32_t most) {
  uint32_t length = 0;
  while (length < most && text[length] != 0) {
    ++length;
  }
  hookWriteU8(out, length);
  for (uint32_t i = 0; i < length; ++i) {
    hookWriteU8(out, (uint8_t)text[i]);
  }
}

/// The text that ends the frame, into `text`, which has room for `most` bytes and a zero.
static bool readText(HookByteReader* in, char* text, uint32_t most) {
  const uint8_t length = hookReadU8(in);
  if (length > most) {
    return false;
  }
  for (uint32_t i = 0; i < length; ++i) {
    text[i] = (char)hookReadU8(in);
  }
  text[length] = 0;
  return hookIsAllRead(in);
}

void hookEncodeBeacon(const HookBeacon* beacon, HookFrame* frame) {
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeBeacon);
  hookWriteU8(&out, beacon->version);
  writeFeatures(&out, &beacon->features);
  hookWriteU32(&out, beacon->dictionary);
  hookWriteU8(&out, beacon->hook_state);
  hookFinishPayload(frame, &out);
}

void hookEncodeWelcome(const HookWelcome* welcome, HookFrame* frame) {
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeWelcome);
  hookWriteU8(&out, welcome->virtual_time ? kHookFlagVirtualTime : 0);
  hookWriteU24(&out, welcome->link);
  hookWriteU24(&out, welcome->newest_session);
  hookFinishPayload(frame, &out);
}

void hookEncodeHello(const HookHello* hello, HookFrame* frame) {
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeHello);
  hookWriteU8(&out, hello->version);
  writeFeatures(&out, &hello->features);
  hookWriteU32(&out, hello->dictionary);
  hookWriteU24(&out, hello->link);
  writeText(&out, hello->mission_name, kHookMostNameBytes);
  hookFinishPayload(frame, &out);
}

void hookEncodeNote(const HookMissionNote* note, HookFrame* frame) {
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeNote);
  hookWriteF64(&out, note->mission_time_s);
  hookWriteU8(&out, note->kind);
  writeText(&out, note->text, kHookMostNoteBytes);
  hookFinishPayload(frame, &out);
}

void hookEncodeTransition(const HookTransitionNotice* notice, HookFrame* frame) {
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeTransition);
  hookWriteF64(&out, notice->mission_time_s);
  hookWriteU8(&out, notice->transition);
  hookWriteU32(&out, notice->from);
  hookWriteU32(&out, notice->to);
  hookWriteU32(&out, notice->fired_case);
  hookWriteU8(&out, notice->list);
  hookFinishPayload(frame, &out);
}

void hookEncodeDone(const HookDone* done, HookFrame* frame) {
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeDone);
  hookWriteU8(&out, done->answered);
  hookWriteU24(&out, done->session);
  hookWriteF64(&out, done->status.mission_time_s);
  hookWriteU32(&out, done->status.state);
  hookWriteU8(&out, done->status.stack_depth);
  hookWriteU8(&out, done->status.phase);
  hookFinishPayload(frame, &out);
}

bool hookDecodeBeacon(const HookFrame* frame, HookBeacon* beacon) {
  HookByteReader in = hookPayloadOf(frame);
  beacon->version = hookReadU8(&in);
  if (frame->type != kHookMessageTypeBeacon || !in.good) {
    return false;
  }
  if (beacon->version != kHookProtocolVersion) {
    return true;  // the rest of another version's Hello has an unknown layout
  }
  readFeatures(&in, &beacon->features);
  beacon->dictionary = hookReadU32(&in);
  beacon->hook_state = hookReadU8(&in);
  return hookIsAllRead(&in) && hookIsState(beacon->hook_state);
}

bool hookDecodeWelcome(const HookFrame* frame, HookWelcome* welcome) {
  HookByteReader in = hookPayloadOf(frame);
  const uint32_t flags = hookReadU8(&in);
  welcome->virtual_time = (flags & kHookFlagVirtualTime) != 0;
  welcome->link = hookReadU24(&in);
  welcome->newest_session = hookReadU24(&in);
  return frame->type == kHookMessageTypeWelcome && hookIsAllRead(&in) &&
         (flags & ~(uint32_t)kHookFlagVirtualTime) == 0;
}

bool hookDecodeHello(const HookFrame* frame, HookHello* hello) {
  HookByteReader in = hookPayloadOf(frame);
  hello->version = hookReadU8(&in);
  if (frame->type != kHookMessageTypeHello || !in.good) {
    return false;
  }
  if (hello->version != kHookProtocolVersion) {
    return true;
  }
  readFeatures(&in, &hello->features);
  hello->dictionary = hookReadU32(&in);
  hello->link = hookReadU24(&in);
  return hello->link != 0 && readText(&in, hello->mission_name, kHookMostNameBytes);
}

bool hookDecodeTransition(const HookFrame* frame, HookTransitionNotice* notice) {
  HookByteReader in = hookPayloadOf(frame);
  notice->mission_time_s = hookReadF64(&in);
  notice->transition = hookReadU8(&in);
  notice->from = hookReadU32(&in);
  notice->to = hookReadU32(&in);
  notice->fired_case = hookReadU32(&in);
  notice->list = hookReadU8(&in);
  return frame->type == kHookMessageTypeTransition && hookIsAllRead(&in) &&
         notice->list <= kMostList && hookIsFinite(notice->mission_time_s);
}

bool hookDecodeNote(const HookFrame* frame, HookMissionNote* note) {
  HookByteReader in = hookPayloadOf(frame);
  note->mission_time_s = hookReadF64(&in);
  note->kind = hookReadU8(&in);
  return frame->type == kHookMessageTypeNote && hookIsFinite(note->mission_time_s) &&
         note->kind <= kMostNoteKind && readText(&in, note->text, kHookMostNoteBytes);
}

bool hookDecodeDone(const HookFrame* frame, HookDone* done) {
  HookByteReader in = hookPayloadOf(frame);
  done->answered = hookReadU8(&in);
  done->session = hookReadU24(&in);
  done->status.mission_time_s = hookReadF64(&in);
  done->status.state = hookReadU32(&in);
  done->status.stack_depth = hookReadU8(&in);
  done->status.phase = hookReadU8(&in);
  return frame->type == kHookMessageTypeDone && hookIsAllRead(&in) &&
         hookIsFinite(done->status.mission_time_s) &&
         done->status.phase <= kHookMissionPhaseFinished;
}

bool hookExpectsAnswer(const HookFrame* frame) {
  switch (frame->type) {
#define MESSAGE(name, number, expects_answer) \
  case kHookMessageType##name:                \
    return expects_answer;
#include "hooks/protocol/messages.def"
    default:
      return false;
  }
}
