// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/tick.h"

#include "hooks/protocol/crc.h"
#include "hooks/protocol/numbers.h"
#include "hooks/protocol/payload.h"

namespace glider::hooks {
namespace {

constexpr uint32_t kHeadBytes = 24;
constexpr uint32_t kSubscriptionBytes = 7;
constexpr uint32_t kWidest = 8;
constexpr uint32_t kMapBytes = kMostSubscriptions / 8;

static_assert(kHeadBytes + 2 * kMapBytes + kMostSubscriptions * kWidest <= kMostPayload,
              "the largest Tick fits a frame");
static_assert(1 + kMostSubscriptions * kSubscriptionBytes <= kMostPayload);

/// One bit per subscribed sensor, the first in the lowest bit of the first byte.
struct BitMap {
  uint8_t bytes[kMapBytes] = {};

  void set(uint32_t index) {
    bytes[index / 8] = static_cast<uint8_t>(bytes[index / 8] | (1U << (index % 8)));
  }
  [[nodiscard]] bool has(uint32_t index) const {
    return ((uint32_t{bytes[index / 8]} >> (index % 8)) & 1U) != 0;
  }
};

uint32_t mapBytes(uint32_t count) {
  return (count + 7) / 8;
}

void write(ByteWriter& out, const BitMap& map, uint32_t count) {
  for (uint32_t i = 0; i < mapBytes(count); ++i) {
    out.u8(map.bytes[i]);
  }
}

/// False when a bit is set that does not represent a sensor.
bool read(ByteReader& in, uint32_t count, BitMap& map) {
  for (uint32_t i = 0; i < mapBytes(count); ++i) {
    map.bytes[i] = in.u8();
  }
  for (uint32_t i = count; i < 8 * mapBytes(count); ++i) {
    if (map.has(i)) {
      return false;
    }
  }
  return true;
}

uint32_t countOf(const Subscribe& subscribe) {
  return subscribe.count < kMostSubscriptions ? subscribe.count : kMostSubscriptions;
}

void writeList(ByteWriter& out, const Subscribe& subscribe) {
  for (uint32_t i = 0; i < countOf(subscribe); ++i) {
    const Subscription& wanted = subscribe.sensors[i];
    out.u16(wanted.id);
    out.u8(wanted.every);
    out.f32(wanted.dead_band);
  }
}

bool isSubscription(const GliderDictionary& dictionary, const Subscription& wanted) {
  return sensorWidth(dictionary, wanted.id) != 0 && wanted.every != 0 && wanted.dead_band >= 0 &&
         isFinite(static_cast<double>(wanted.dead_band));
}

void writeHead(ByteWriter& out, const TickHead& head) {
  out.u8(head.virtual_time ? kFlagVirtualTime : 0);
  out.u24(head.link);
  out.f32(static_cast<float>(head.vehicle_time_s));
  out.u24(head.cycle);
  out.u16(head.subscription);
  out.u8(static_cast<uint8_t>(head.hook_state));
  out.u8(static_cast<uint8_t>(head.answer));
  out.u16(head.answered_sequence);
  out.u24(head.session);
  out.u32(head.clock_s);
}

}  // namespace

void encode(const Subscribe& subscribe, Frame& frame) {
  ByteWriter out = startPayload(frame, MessageType::Subscribe);
  out.u8(static_cast<uint8_t>(countOf(subscribe)));
  writeList(out, subscribe);
  finishPayload(frame, out);
}

bool decode(const GliderDictionary& dictionary, const Frame& frame, Subscribe& subscribe) {
  ByteReader in = payloadOf(frame);
  subscribe.count = in.u8();
  if (frame.type != MessageType::Subscribe || subscribe.count > kMostSubscriptions) {
    return false;
  }
  for (uint32_t i = 0; i < subscribe.count; ++i) {
    Subscription& wanted = subscribe.sensors[i];
    wanted.id = in.u16();
    wanted.every = in.u8();
    wanted.dead_band = in.f32();
    if (!isSubscription(dictionary, wanted)) {
      return false;
    }
  }
  return in.exact();
}

uint16_t subscriptionCheck(const Subscribe& subscribe) {
  uint8_t bytes[kMostSubscriptions * kSubscriptionBytes];
  ByteWriter out(bytes, sizeof bytes);
  writeList(out, subscribe);
  return crc16(bytes, out.size());
}

void encode(const GliderDictionary& dictionary, const TickHead& head, const Subscribe& subscription,
            const TickReadings& readings, Frame& frame) {
  ByteWriter out = startPayload(frame, MessageType::Tick);
  writeHead(out, head);
  const uint32_t count = countOf(subscription);
  BitMap reported;
  BitMap with_value;
  for (uint32_t i = 0; i < count; ++i) {
    if (readings.told[i] != ReadingReport::Nothing) {
      reported.set(i);
    }
    if (readings.told[i] == ReadingReport::Value) {
      with_value.set(i);
    }
  }
  write(out, reported, count);
  write(out, with_value, count);
  for (uint32_t i = 0; i < count; ++i) {
    if (with_value.has(i)) {
      const uint16_t id = subscription.sensors[i].id;
      const uint32_t width = sensorWidth(dictionary, id);
      out.bits(toWire(width, readings.values[i]), width);
    }
  }
  finishPayload(frame, out);
}

bool decode(const Frame& frame, TickHead& head) {
  ByteReader in = payloadOf(frame);
  const uint8_t flags = in.u8();
  head.virtual_time = (flags & kFlagVirtualTime) != 0;
  head.link = in.u24();
  head.vehicle_time_s = static_cast<double>(in.f32());
  head.cycle = in.u24();
  head.subscription = in.u16();
  const uint8_t state = in.u8();
  const uint8_t answer = in.u8();
  head.hook_state = static_cast<HookState>(state);
  head.answer = static_cast<HookAnswer>(answer);
  head.answered_sequence = in.u16();
  head.session = in.u24();
  head.clock_s = in.u32();
  return frame.type == MessageType::Tick && in.good() && (flags & ~kFlagVirtualTime) == 0 &&
         isFinite(head.vehicle_time_s) && isHookState(state) && isHookAnswer(answer);
}

bool decode(const GliderDictionary& dictionary, const Frame& frame, const Subscribe& subscription,
            TickReadings& readings) {
  ByteReader in = payloadOf(frame);
  in.skip(kHeadBytes);
  const uint32_t count = countOf(subscription);
  BitMap reported;
  BitMap with_value;
  if (frame.type != MessageType::Tick || !read(in, count, reported) ||
      !read(in, count, with_value)) {
    return false;
  }
  for (uint32_t i = 0; i < count; ++i) {
    const uint16_t id = subscription.sensors[i].id;
    readings.told[i] = !reported.has(i)    ? ReadingReport::Nothing
                       : with_value.has(i) ? ReadingReport::Value
                                           : ReadingReport::Unchanged;
    if (with_value.has(i)) {
      if (!reported.has(i)) {
        return false;
      }
      const uint32_t width = sensorWidth(dictionary, id);
      readings.values[i] = fromWire(width, in.bits(width));
    }
  }
  return in.exact();
}

}  // namespace glider::hooks
