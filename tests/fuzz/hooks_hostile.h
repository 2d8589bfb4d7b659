// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "hooks/hookbeh/hookbeh.h"
#include "hooks/hookprog/hookprog.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/nap.h"
#include "hooks/protocol/sensor_list.h"
#include "hooks/protocol/tick.h"
#include "tests/slocum.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>

/// What the fuzzer and the unit test do with hostile bytes.
namespace glider::hooks {

inline void require(bool condition) {
  if (!condition) {
    std::abort();
  }
}

/// A stream that holds the hostile bytes and swallows what is written.
struct HostileStream {
  const uint8_t* bytes;
  uint32_t count;
  GliderByteStream stream() {
    return {this,
            [](void* self, uint8_t* out, uint32_t capacity) {
              auto& hostile = *static_cast<HostileStream*>(self);
              const uint32_t n = capacity < hostile.count ? capacity : hostile.count;
              if (n > 0) {
                std::memcpy(out, hostile.bytes, n);
              }
              hostile.bytes += n;
              hostile.count -= n;
              return static_cast<int32_t>(n);
            },
            [](void*, const uint8_t*, uint32_t size) { return static_cast<int32_t>(size); }};
  }
};

/// A data memory with the hostile bytes in its sensors, some of them new in each cycle.
struct HostileMemory {
  const uint8_t* bytes;
  uint32_t count;
  uint32_t at = 0;

  ScienceMemory memory() {
    return {this,
            [](void* self, uint16_t, bool* fresh) {
              auto& hostile = *static_cast<HostileMemory*>(self);
              double value = 0;
              if (hostile.count < sizeof value) {
                *fresh = false;
                return value;
              }
              hostile.at = (hostile.at + 1) % (hostile.count - uint32_t{sizeof value} + 1);
              std::memcpy(&value, hostile.bytes + hostile.at, sizeof value);
              *fresh = hostile.bytes[hostile.at] % 2 == 0;
              return value;
            },
            [](void*, uint16_t id, double) { require(isScienceSensor(id)); }};
  }
};

/// What decodes must encode to the same bytes again: no two meanings, nothing left unread.
template <typename Message>
void requireSame(const Frame& frame) {
  Message message;
  if (!decode(frame, message)) {
    return;
  }
  Frame again;
  encode(message, again);
  require(again.type == frame.type && again.size == frame.size &&
          std::memcmp(again.payload, frame.payload, frame.size) == 0);
}

/// Of each width one sensor, and one with a dead band.
inline Subscribe hostileSubscription() {
  return {4, {{3, 1, 0}, {5, 1, 0}, {13, 2, 0}, {31, 1, 0.5F}}};
}

inline void requireSameTick(const Frame& frame) {
  TickHead head;
  TickReadings readings;
  if (!decode(frame, head) || !decode(frame, hostileSubscription(), readings)) {
    return;
  }
  Frame again;
  encode(head, hostileSubscription(), readings, again);
  require(again.size == frame.size);
  TickReadings same;  // NaNs with a payload come back without
  require(decode(again, hostileSubscription(), same));
  require(std::memcmp(readings.told, same.told, sizeof same.told) == 0);
}

inline void decodeAll(const Frame& frame) {
  Beacon beacon;
  Hello hello;
  // Only the first byte of another version's Beacon and Hello is read.
  if (decode(frame, beacon) && beacon.version == kProtocolVersion) {
    requireSame<Beacon>(frame);
  }
  if (decode(frame, hello) && hello.version == kProtocolVersion) {
    // A name with a zero inside ends there.
    Frame again;
    encode(hello, again);
    require(again.size <= frame.size);
  }
  requireSame<Welcome>(frame);
  requireSame<Subscribe>(frame);
  requireSame<TransitionNotice>(frame);
  requireSame<Done>(frame);
  MissionNote note;
  if (decode(frame, note)) {  // a text with a zero inside ends there
    Frame again;
    encode(note, again);
    require(again.size <= frame.size);
  }
  Nap nap;
  if (decode(frame, hostileSubscription(), nap)) {  // the value of Known goes as 0
    Frame again;
    encode(nap, again);
    require(again.size == frame.size && decode(again, hostileSubscription(), nap));
  }
  requireSameTick(frame);
  SensorList list;
  if (decodeList(frame, list)) {
    require(list.count <= kMostListed);
  }
  (void)expectsAnswer(frame);
}

/// The bytes as the payload of every kind of frame, with a right CRC: past the checksum into the
/// decoders.
inline void feedDecoders(const uint8_t* bytes, uint32_t count) {
  FrameDecoder raw;
  for (uint32_t i = 0; i < count; ++i) {
    if (raw.push(bytes[i])) {
      decodeAll(raw.frame());
    }
  }
  const MessageType types[] = {
#define MESSAGE(name, number, expects_answer) MessageType::name,
#include "hooks/protocol/messages.def"
#undef MESSAGE
  };
  for (const MessageType type : types) {
    Frame frame;
    frame.type = type;
    frame.size = static_cast<uint16_t>(count < kMostPayload ? count : kMostPayload);
    if (frame.size > 0) {
      std::memcpy(frame.payload, bytes, frame.size);
    }
    decodeAll(frame);
  }
}

/// The bytes cut into frames of right form, {length, type, payload…}, as a stream.
inline uint32_t asFrames(const uint8_t* bytes, uint32_t count, uint8_t* out, uint32_t capacity) {
  uint32_t size = 0;
  uint32_t at = 0;
  while (at + 2 <= count && size + kMostEncodedBytes <= capacity) {
    Frame frame;
    const uint32_t wanted = bytes[at];
    frame.type = static_cast<MessageType>(bytes[at + 1]);
    at += 2;
    frame.size = static_cast<uint16_t>(wanted < count - at ? wanted : count - at);
    frame.sequence = static_cast<uint8_t>(at);
    if (frame.size > 0) {
      std::memcpy(frame.payload, bytes + at, frame.size);
    }
    at += frame.size;
    size += encodeFrame(frame, out + size);
  }
  return size;
}

inline void feedClient(const uint8_t* bytes, uint32_t count) {
  const Subscribe subscription = hostileSubscription();
  ClientOptions options;
  options.mission_name = "hostile";
  options.sensors = subscription.sensors;
  options.sensor_count = subscription.count;
  Client client(gliderDictionary, options);
  HostileStream hostile{bytes, count};
  const GliderClock clock{nullptr, [](void*) { return 0.0; }};
  const GliderByteStream stream = hostile.stream();
  for (uint32_t polls = 0; polls < count + 4; ++polls) {
    const ClientEvent event = client.poll(stream, clock);
    if (event == ClientEvent::Tick) {
      require(client.tick().reading_count <= kMostSubscriptions);
      client.instruct({});
      client.nap({});
      client.done({}, stream);
    } else if (event == ClientEvent::Nothing && hostile.count == 0) {
      break;
    }
  }
}

inline void feedHookprog(const uint8_t* bytes, uint32_t count) {
  Hookprog hookprog(gliderDictionary);
  HostileStream sbc{bytes, count};
  HostileMemory memory{bytes, count};
  for (int second = 0; second < 6; ++second) {
    hookprog.run(second, memory.memory(), sbc.stream());
    while (hookprog.nextEvent().kind != SeatEvent::Kind::None) {
    }
  }
}

/// The bytes as the doubles of one cycle after the other.
inline void feedHookbeh(const uint8_t* bytes, uint32_t count) {
  HookbehArgs args;
  Hookbeh hookbeh(args, kHull);
  constexpr uint32_t kSize = sizeof(HookbehInputs);
  for (; count >= kSize; bytes += kSize, count -= kSize) {
    HookbehInputs inputs;
    std::memcpy(&inputs, bytes, sizeof inputs);
    const HookbehOutputs out = hookbeh.cycle(inputs);
    require(out.commanding == (out.state == HookState::Active));
    require(out.pitch_rad >= -args.steepest_pitch_rad - 1e-6 &&
            out.pitch_rad <= args.steepest_pitch_rad + 1e-6);
    require(out.fin_rad >= -kHull.fin_rad && out.fin_rad <= kHull.fin_rad);
    const bool actuators = out.pitch_mode == PitchMode::Battery;
    require(out.pump_cc >= (actuators ? -kHull.pump_cc : args.dive_pump_cc) &&
            out.pump_cc <= (actuators ? kHull.pump_cc : args.climb_pump_cc));
    require(out.battery_in >= -kHull.battery_in && out.battery_in <= kHull.battery_in);
    require(!out.commanding || inputs.depth_m <= args.greatest_depth_m ||
            out.pump_cc == args.climb_pump_cc);
  }
}

inline void feedEverything(const uint8_t* bytes, uint32_t count) {
  feedDecoders(bytes, count);
  static uint8_t frames[1U << 16U];
  const uint32_t size = asFrames(bytes, count, frames, sizeof frames);
  feedClient(bytes, count);
  feedClient(frames, size);
  feedHookprog(bytes, count);
  feedHookprog(frames, size);
  feedHookbeh(bytes, count);
}

}  // namespace glider::hooks
