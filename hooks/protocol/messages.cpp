// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/messages.h"

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/numbers.h"

namespace glider::hooks {
namespace {

constexpr uint8_t kFlagMore = 1;
constexpr uint8_t kFlagContinues = 2;
constexpr uint8_t kFlagVirtualTime = 4;
constexpr uint8_t kMostList = 3;  // of a transition
constexpr uint8_t kMostNoteKind = 1;
constexpr uint32_t kTickCountAt = 27;  // where the number of readings stands in a Tick

ByteWriter start(Frame& frame, MessageType type) {
  frame.type = type;
  frame.size = 0;
  return {frame.payload, kMostPayload};
}

void finish(Frame& frame, const ByteWriter& writer) {
  frame.size = static_cast<uint8_t>(writer.size());
}

ByteReader reader(const Frame& frame) {
  return {frame.payload, frame.size};
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

bool isHookState(uint8_t value) {
  return value <= static_cast<uint8_t>(HookState::Complete);
}
bool isHookAnswer(uint8_t value) {
  return value <= static_cast<uint8_t>(HookAnswer::NotReady);
}

void writeValue(ByteWriter& out, const SensorValue& value) {
  out.u16(value.id);
  switch (sensorWidth(value.id)) {
    case 1: {
      // -128 stands for NaN, so that a one-byte sensor can be unknown too.
      const double v = value.value;
      const int whole = v != v ? -128 : v >= 127 ? 127 : v <= -127 ? -127 : static_cast<int>(v);
      out.u8(static_cast<uint8_t>(whole));
      break;
    }
    case 4:
      out.f32(static_cast<float>(value.value));
      break;
    default:
      out.f64(value.value);
      break;
  }
}

/// Reads `count` values and nothing more up to the end of the frame.
bool readValues(ByteReader& in, uint32_t count, SensorList& list) {
  list.count = 0;
  for (uint32_t i = 0; i < count && i < kMostListed && in.good(); ++i) {
    SensorValue& value = list.values[i];
    value.id = in.u16();
    switch (sensorWidth(value.id)) {
      case 1: {
        const auto whole = static_cast<int8_t>(in.u8());
        value.value = whole == -128 ? __builtin_nan("") : whole;
        break;
      }
      case 4:
        value.value = static_cast<double>(in.f32());
        break;
      case 8:
        value.value = in.f64();
        break;
      default:
        return false;
    }
    ++list.count;
  }
  return in.exact() && list.count == count;
}

uint32_t countAt(const Frame& frame) {
  return frame.type == MessageType::Tick ? kTickCountAt : 0;
}

}  // namespace

void encode(const Beacon& beacon, Frame& frame) {
  ByteWriter out = start(frame, MessageType::Beacon);
  out.u8(beacon.version);
  out.u8(beacon.virtual_time ? kFlagVirtualTime : 0);
  out.u32(beacon.dictionary);
  out.u8(static_cast<uint8_t>(beacon.hook_state));
  finish(frame, out);
}

void encode(const Welcome& welcome, Frame& frame) {
  ByteWriter out = start(frame, MessageType::Welcome);
  out.u8(welcome.virtual_time ? kFlagVirtualTime : 0);
  out.u32(welcome.link);
  out.u32(welcome.newest_session);
  finish(frame, out);
}

void encode(const TickHead& head, Frame& frame) {
  ByteWriter out = start(frame, MessageType::Tick);
  out.u8(static_cast<uint8_t>((head.more ? kFlagMore : 0) | (head.continues ? kFlagContinues : 0) |
                              (head.virtual_time ? kFlagVirtualTime : 0)));
  out.u32(head.link);
  out.f64(head.vehicle_time_s);
  out.u32(head.cycle);
  out.u16(head.subscription);
  out.u8(static_cast<uint8_t>(head.hook_state));
  out.u8(static_cast<uint8_t>(head.answer));
  out.u16(head.answered_sequence);
  out.u32(head.session);
  out.u8(0);
  finish(frame, out);
}

void encode(const Hello& hello, Frame& frame) {
  ByteWriter out = start(frame, MessageType::Hello);
  out.u8(hello.version);
  out.u32(hello.dictionary);
  out.u32(hello.link);
  writeText(out, hello.mission_name, kMostNameBytes);
  finish(frame, out);
}

void encode(const MissionNote& note, Frame& frame) {
  ByteWriter out = start(frame, MessageType::Note);
  out.f64(note.mission_time_s);
  out.u8(note.kind);
  writeText(out, note.text, kMostNoteBytes);
  finish(frame, out);
}

void encode(const Subscribe& subscribe, Frame& frame) {
  ByteWriter out = start(frame, MessageType::Subscribe);
  const uint32_t count =
      subscribe.count < kMostSubscriptions ? subscribe.count : kMostSubscriptions;
  out.u8(static_cast<uint8_t>(count));
  for (uint32_t i = 0; i < count; ++i) {
    out.u16(subscribe.ids[i]);
  }
  finish(frame, out);
}

void encode(const TransitionNotice& notice, Frame& frame) {
  ByteWriter out = start(frame, MessageType::Transition);
  out.f64(notice.mission_time_s);
  out.u8(notice.transition);
  out.u32(notice.from);
  out.u32(notice.to);
  out.u32(notice.fired_case);
  out.u8(notice.list);
  finish(frame, out);
}

void encode(const Done& done, Frame& frame) {
  ByteWriter out = start(frame, MessageType::Done);
  out.u8(done.answered);
  out.u32(done.session);
  out.f64(done.status.mission_time_s);
  out.u32(done.status.state);
  out.u8(done.status.stack_depth);
  out.u8(done.status.phase);
  finish(frame, out);
}

void encodeEmptyList(MessageType type, Frame& frame) {
  ByteWriter out = start(frame, type);
  out.u8(0);
  finish(frame, out);
}

bool appendValue(Frame& frame, const SensorValue& value) {
  const uint32_t width = sensorWidth(value.id);
  if (width == 0 || frame.size + 2 + width > kMostPayload) {
    return false;
  }
  ByteWriter out(frame.payload + frame.size, kMostPayload - frame.size);
  writeValue(out, value);
  frame.size = static_cast<uint8_t>(frame.size + out.size());
  ++frame.payload[countAt(frame)];
  return true;
}

void markMore(Frame& tick) {
  tick.payload[0] |= kFlagMore;
}

bool decode(const Frame& frame, Beacon& beacon) {
  ByteReader in = reader(frame);
  beacon.version = in.u8();
  if (frame.type != MessageType::Beacon || !in.good()) {
    return false;
  }
  if (beacon.version != kProtocolVersion) {
    return true;  // the rest of another version is not ours to read
  }
  const uint8_t flags = in.u8();
  beacon.virtual_time = (flags & kFlagVirtualTime) != 0;
  beacon.dictionary = in.u32();
  const uint8_t state = in.u8();
  beacon.hook_state = static_cast<HookState>(state);
  return in.exact() && (flags & ~kFlagVirtualTime) == 0 && isHookState(state);
}

bool decode(const Frame& frame, Welcome& welcome) {
  ByteReader in = reader(frame);
  const uint8_t flags = in.u8();
  welcome.virtual_time = (flags & kFlagVirtualTime) != 0;
  welcome.link = in.u32();
  welcome.newest_session = in.u32();
  return frame.type == MessageType::Welcome && in.exact() && (flags & ~kFlagVirtualTime) == 0 &&
         welcome.link <= kMostSession && welcome.newest_session <= kMostSession;
}

bool decode(const Frame& frame, TickHead& head, SensorList& readings) {
  ByteReader in = reader(frame);
  const uint8_t flags = in.u8();
  head.more = (flags & kFlagMore) != 0;
  head.continues = (flags & kFlagContinues) != 0;
  head.virtual_time = (flags & kFlagVirtualTime) != 0;
  head.link = in.u32();
  head.vehicle_time_s = in.f64();
  head.cycle = in.u32();
  head.subscription = in.u16();
  const uint8_t state = in.u8();
  const uint8_t answer = in.u8();
  head.hook_state = static_cast<HookState>(state);
  head.answer = static_cast<HookAnswer>(answer);
  head.answered_sequence = in.u16();
  head.session = in.u32();
  const uint8_t count = in.u8();
  return frame.type == MessageType::Tick && in.good() && flags <= 7 &&
         isFinite(head.vehicle_time_s) && isHookState(state) && isHookAnswer(answer) &&
         head.session <= kMostSession && readValues(in, count, readings);
}

bool decode(const Frame& frame, Hello& hello) {
  ByteReader in = reader(frame);
  hello.version = in.u8();
  if (frame.type != MessageType::Hello || !in.good()) {
    return false;
  }
  if (hello.version != kProtocolVersion) {
    return true;
  }
  hello.dictionary = in.u32();
  hello.link = in.u32();
  return hello.link != 0 && hello.link <= kMostSession &&
         readText(in, hello.mission_name, kMostNameBytes);
}

bool decode(const Frame& frame, Subscribe& subscribe) {
  ByteReader in = reader(frame);
  subscribe.count = in.u8();
  if (subscribe.count > kMostSubscriptions) {
    return false;
  }
  for (uint32_t i = 0; i < subscribe.count; ++i) {
    subscribe.ids[i] = in.u16();
    if (sensorWidth(subscribe.ids[i]) == 0) {
      return false;
    }
  }
  return frame.type == MessageType::Subscribe && in.exact();
}

bool decode(const Frame& frame, TransitionNotice& notice) {
  ByteReader in = reader(frame);
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
  ByteReader in = reader(frame);
  note.mission_time_s = in.f64();
  note.kind = in.u8();
  return frame.type == MessageType::Note && isFinite(note.mission_time_s) &&
         note.kind <= kMostNoteKind && readText(in, note.text, kMostNoteBytes);
}

bool decode(const Frame& frame, Done& done) {
  ByteReader in = reader(frame);
  done.answered = in.u8();
  done.session = in.u32();
  done.status.mission_time_s = in.f64();
  done.status.state = in.u32();
  done.status.stack_depth = in.u8();
  done.status.phase = in.u8();
  return frame.type == MessageType::Done && in.exact() && done.session <= kMostSession &&
         isFinite(done.status.mission_time_s) && done.status.phase <= 2;
}

bool decodeList(const Frame& frame, SensorList& list) {
  if (frame.type != MessageType::Write && frame.type != MessageType::Sensors) {
    return false;
  }
  ByteReader in = reader(frame);
  const uint8_t count = in.u8();
  return readValues(in, count, list);
}

bool expectsAnswer(const Frame& frame) {
  if (frame.type == MessageType::Tick) {
    return frame.size > 0 && (frame.payload[0] & kFlagMore) == 0;
  }
  switch (frame.type) {
#define MESSAGE(name, number, expects_answer) \
  case MessageType::name:                     \
    return expects_answer;
#include "hooks/protocol/messages.def"
#undef MESSAGE
  }
  return false;
}

uint16_t subscriptionCheck(const uint16_t* ids, uint32_t count) {
  uint8_t bytes[2 * kMostSubscriptions];
  ByteWriter out(bytes, sizeof bytes);
  for (uint32_t i = 0; i < count; ++i) {
    out.u16(ids[i]);
  }
  return crc16(bytes, out.size());
}

uint32_t nextSession(uint32_t session) {
  return session >= kMostSession ? 1 : session + 1;
}

bool isNewerSession(uint32_t session, uint32_t other) {
  if (other == 0) {
    return session != 0;
  }
  const uint32_t ahead = session >= other ? session - other : session + kMostSession - other;
  return ahead != 0 && ahead <= kMostSession / 2;
}

}  // namespace glider::hooks
