// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/messages.h"

#include "hooks/protocol/numbers.h"
#include "hooks/protocol/payload.h"

namespace glider::hooks {
namespace {

constexpr uint8_t kMostList = 1;  // of a transition: only these two change the state
constexpr uint8_t kMostNoteKind = 1;

void writeFeatures(ByteWriter& out, const Features& features) {
  out.u16(features.offers);
  out.u16(features.needs);
}

Features readFeatures(ByteReader& in) {
  Features features;
  features.offers = in.u16();
  features.needs = in.u16();
  return features;
}

/// Its length, then the text, at most `most` bytes of it.
void writeText(ByteWriter& out, const char* text, uint32_t most) {
  uint32_t length = 0;
  while (length < most && text[length] != 0) {
    ++length;
  }
  out.u8(static_cast<uint8_t>(length));
  for (uint32_t i = 0; i < length; ++i) {
    out.u8(static_cast<uint8_t>(text[i]));
  }
}

/// The text that ends the frame, into `text`, which has room for `most` bytes and a zero.
bool readText(ByteReader& in, char* text, uint32_t most) {
  const uint8_t length = in.u8();
  if (length > most) {
    return false;
  }
  for (uint32_t i = 0; i < length; ++i) {
    text[i] = static_cast<char>(in.u8());
  }
  text[length] = 0;
  return in.exact();
}

}  // namespace

void encode(const Beacon& beacon, Frame& frame) {
  ByteWriter out = startPayload(frame, MessageType::Beacon);
  out.u8(beacon.version);
  writeFeatures(out, beacon.features);
  out.u32(beacon.dictionary);
  out.u8(static_cast<uint8_t>(beacon.hook_state));
  finishPayload(frame, out);
}

void encode(const Welcome& welcome, Frame& frame) {
  ByteWriter out = startPayload(frame, MessageType::Welcome);
  out.u8(welcome.virtual_time ? kFlagVirtualTime : 0);
  out.u24(welcome.link);
  out.u24(welcome.newest_session);
  finishPayload(frame, out);
}

void encode(const Hello& hello, Frame& frame) {
  ByteWriter out = startPayload(frame, MessageType::Hello);
  out.u8(hello.version);
  writeFeatures(out, hello.features);
  out.u32(hello.dictionary);
  out.u24(hello.link);
  writeText(out, hello.mission_name, kMostNameBytes);
  finishPayload(frame, out);
}

void encode(const MissionNote& note, Frame& frame) {
  ByteWriter out = startPayload(frame, MessageType::Note);
  out.f64(note.mission_time_s);
  out.u8(note.kind);
  writeText(out, note.text, kMostNoteBytes);
  finishPayload(frame, out);
}

void encode(const TransitionNotice& notice, Frame& frame) {
  ByteWriter out = startPayload(frame, MessageType::Transition);
  out.f64(notice.mission_time_s);
  out.u8(notice.transition);
  out.u32(notice.from);
  out.u32(notice.to);
  out.u32(notice.fired_case);
  out.u8(notice.list);
  finishPayload(frame, out);
}

void encode(const Done& done, Frame& frame) {
  ByteWriter out = startPayload(frame, MessageType::Done);
  out.u8(done.answered);
  out.u24(done.session);
  out.f64(done.status.mission_time_s);
  out.u32(done.status.state);
  out.u8(done.status.stack_depth);
  out.u8(static_cast<uint8_t>(done.status.phase));
  finishPayload(frame, out);
}

bool decode(const Frame& frame, Beacon& beacon) {
  ByteReader in = payloadOf(frame);
  beacon.version = in.u8();
  if (frame.type != MessageType::Beacon || !in.good()) {
    return false;
  }
  if (beacon.version != kProtocolVersion) {
    return true;  // the rest of another version's Hello has an unknown layout
  }
  beacon.features = readFeatures(in);
  beacon.dictionary = in.u32();
  const uint8_t state = in.u8();
  beacon.hook_state = static_cast<HookState>(state);
  return in.exact() && isHookState(state);
}

bool decode(const Frame& frame, Welcome& welcome) {
  ByteReader in = payloadOf(frame);
  const uint8_t flags = in.u8();
  welcome.virtual_time = (flags & kFlagVirtualTime) != 0;
  welcome.link = in.u24();
  welcome.newest_session = in.u24();
  return frame.type == MessageType::Welcome && in.exact() && (flags & ~kFlagVirtualTime) == 0;
}

bool decode(const Frame& frame, Hello& hello) {
  ByteReader in = payloadOf(frame);
  hello.version = in.u8();
  if (frame.type != MessageType::Hello || !in.good()) {
    return false;
  }
  if (hello.version != kProtocolVersion) {
    return true;
  }
  hello.features = readFeatures(in);
  hello.dictionary = in.u32();
  hello.link = in.u24();
  return hello.link != 0 && readText(in, hello.mission_name, kMostNameBytes);
}

bool decode(const Frame& frame, TransitionNotice& notice) {
  ByteReader in = payloadOf(frame);
  notice.mission_time_s = in.f64();
  notice.transition = in.u8();
  notice.from = in.u32();
  notice.to = in.u32();
  notice.fired_case = in.u32();
  notice.list = in.u8();
  return frame.type == MessageType::Transition && in.exact() && notice.list <= kMostList &&
         isFinite(notice.mission_time_s);
}

bool decode(const Frame& frame, MissionNote& note) {
  ByteReader in = payloadOf(frame);
  note.mission_time_s = in.f64();
  note.kind = in.u8();
  return frame.type == MessageType::Note && isFinite(note.mission_time_s) &&
         note.kind <= kMostNoteKind && readText(in, note.text, kMostNoteBytes);
}

bool decode(const Frame& frame, Done& done) {
  ByteReader in = payloadOf(frame);
  done.answered = in.u8();
  done.session = in.u24();
  done.status.mission_time_s = in.f64();
  done.status.state = in.u32();
  done.status.stack_depth = in.u8();
  const uint8_t phase = in.u8();
  done.status.phase = static_cast<MissionPhase>(phase);
  return frame.type == MessageType::Done && in.exact() && isFinite(done.status.mission_time_s) &&
         phase <= static_cast<uint8_t>(MissionPhase::Finished);
}

bool expectsAnswer(const Frame& frame) {
  switch (frame.type) {
#define MESSAGE(name, number, expects_answer) \
  case MessageType::name:                     \
    return expects_answer;
#include "hooks/protocol/messages.def"
#undef MESSAGE
  }
  return false;
}

}  // namespace glider::hooks
