// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/tick.h"

#include "hooks/protocol/crc.h"
#include "hooks/protocol/numbers.h"
#include "hooks/protocol/payload.h"

enum {
  kHeadBytes = 24,
  kSubscriptionBytes = 7,
  kWidest = 8,
  kMapBytes = kHookMostSubscriptions / 8
};

GLIDER_STATIC_ASSERT(LargestTickFits,
                     kHeadBytes + 2 * kMapBytes + kHookMostSubscriptions * kWidest <=
                         kHookMostPayload);
GLIDER_STATIC_ASSERT(LargestSubscribeFits,
                     1 + kHookMostSubscriptions * kSubscriptionBytes <= kHookMostPayload);

/// One bit per subscribed sensor, the first in the lowest bit of the first byte.
typedef struct BitMap {
  uint8_t bytes[kMapBytes];
} BitMap;

static void setBit(BitMap* map, uint32_t index) {
  map->bytes[index / 8] = (uint8_t)(map->bytes[index / 8] | (1U << (index % 8)));
}

static bool hasBit(const BitMap* map, uint32_t index) {
  return (((uint32_t)map->bytes[index / 8] >> (index % 8)) & 1U) != 0;
}

static uint32_t mapBytes(uint32_t count) {
  return (count + 7) / 8;
}

static void writeMap(HookByteWriter* out, const BitMap* map, uint32_t count) {
  for (uint32_t i = 0; i < mapBytes(count); ++i) {
    hookWriteU8(out, map->bytes[i]);
  }
}

/// False when a bit is set that does not represent a sensor.
static bool readMap(HookByteReader* in, uint32_t count, BitMap* map) {
  for (uint32_t i = 0; i < mapBytes(count); ++i) {
    map->bytes[i] = hookReadU8(in);
  }
  for (uint32_t i = count; i < 8 * mapBytes(count); ++i) {
    if (hasBit(map, i)) {
      return false;
    }
  }
  return true;
}

static uint32_t countOf(const HookSubscribe* subscribe) {
  return subscribe->count < kHookMostSubscriptions ? subscribe->count : kHookMostSubscriptions;
}

static void writeList(HookByteWriter* out, const HookSubscribe* subscribe) {
  for (uint32_t i = 0; i < countOf(subscribe); ++i) {
    const HookSubscription* wanted = &subscribe->sensors[i];
    hookWriteU16(out, wanted->id);
    hookWriteU8(out, wanted->every);
    hookWriteF32(out, wanted->dead_band);
  }
}

static bool isSubscription(const GliderDictionary* dictionary, const HookSubscription* wanted) {
  return hookSensorWidth(dictionary, wanted->id) != 0 && wanted->every != 0 &&
         wanted->dead_band >= 0 && hookIsFinite((double)wanted->dead_band);
}

static void writeHead(HookByteWriter* out, const HookTickHead* head) {
  hookWriteU8(out,
              (head->virtual_time ? kHookFlagVirtualTime : 0U) | (head->kept ? kHookFlagKept : 0U));
  hookWriteU24(out, head->link);
  hookWriteF32(out, (float)head->vehicle_time_s);
  hookWriteU24(out, head->cycle);
  hookWriteU16(out, head->subscription);
  hookWriteU8(out, head->hook_state);
  hookWriteU8(out, head->answer);
  hookWriteU16(out, head->answered_sequence);
  hookWriteU24(out, head->session);
  hookWriteU32(out, head->clock_s);
}

void hookEncodeSubscribe(const HookSubscribe* subscribe, HookFrame* frame) {
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeSubscribe);
  hookWriteU8(&out, countOf(subscribe));
  writeList(&out, subscribe);
  hookFinishPayload(frame, &out);
}

bool hookDecodeSubscribe(const GliderDictionary* dictionary, const HookFrame* frame,
                         HookSubscribe* subscribe) {
  HookByteReader in = hookPayloadOf(frame);
  subscribe->count = hookReadU8(&in);
  if (frame->type != kHookMessageTypeSubscribe || subscribe->count > kHookMostSubscriptions) {
    return false;
  }
  for (uint32_t i = 0; i < subscribe->count; ++i) {
    HookSubscription* wanted = &subscribe->sensors[i];
    wanted->id = hookReadU16(&in);
    wanted->every = hookReadU8(&in);
    wanted->dead_band = hookReadF32(&in);
    if (!isSubscription(dictionary, wanted)) {
      return false;
    }
  }
  return hookIsAllRead(&in);
}

uint16_t hookSubscriptionCheck(const HookSubscribe* subscribe) {
  uint8_t bytes[kHookMostSubscriptions * kSubscriptionBytes];
  HookByteWriter out = hookWriterTo(bytes, sizeof bytes);
  writeList(&out, subscribe);
  return hookCrc16(bytes, out.size, kHookCrc16Start);
}

void hookEncodeTick(const GliderDictionary* dictionary, const HookTickHead* head,
                    const HookSubscribe* subscription, const HookTickReadings* readings,
                    HookFrame* frame) {
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeTick);
  writeHead(&out, head);
  const uint32_t count = countOf(subscription);
  BitMap reported = {{0}};
  BitMap with_value = {{0}};
  for (uint32_t i = 0; i < count; ++i) {
    if (readings->told[i] != kHookReadingReportNothing) {
      setBit(&reported, i);
    }
    if (readings->told[i] == kHookReadingReportValue) {
      setBit(&with_value, i);
    }
  }
  writeMap(&out, &reported, count);
  writeMap(&out, &with_value, count);
  for (uint32_t i = 0; i < count; ++i) {
    if (hasBit(&with_value, i)) {
      const uint32_t width = hookSensorWidth(dictionary, subscription->sensors[i].id);
      hookWrite(&out, hookToWire(width, readings->values[i]), width);
    }
  }
  hookFinishPayload(frame, &out);
}

uint32_t hookGreatestTick(const GliderDictionary* dictionary, const HookSubscribe* subscription) {
  const uint32_t count = countOf(subscription);
  uint32_t bytes = kHeadBytes + 2 * mapBytes(count);
  for (uint32_t i = 0; i < count; ++i) {
    bytes += hookSensorWidth(dictionary, subscription->sensors[i].id);
  }
  return bytes;
}

void hookMarkTickKept(HookFrame* frame, bool kept) {
  const uint32_t others = frame->payload[0] & ~(uint32_t)kHookFlagKept;
  frame->payload[0] = (uint8_t)(others | (kept ? kHookFlagKept : 0U));
}

bool hookDecodeTickHead(const HookFrame* frame, HookTickHead* head) {
  HookByteReader in = hookPayloadOf(frame);
  const uint32_t flags = hookReadU8(&in);
  head->virtual_time = (flags & kHookFlagVirtualTime) != 0;
  head->kept = (flags & kHookFlagKept) != 0;
  head->link = hookReadU24(&in);
  head->vehicle_time_s = (double)hookReadF32(&in);
  head->cycle = hookReadU24(&in);
  head->subscription = hookReadU16(&in);
  head->hook_state = hookReadU8(&in);
  head->answer = hookReadU8(&in);
  head->answered_sequence = hookReadU16(&in);
  head->session = hookReadU24(&in);
  head->clock_s = hookReadU32(&in);
  return frame->type == kHookMessageTypeTick && in.good &&
         (flags & ~(uint32_t)(kHookFlagVirtualTime | kHookFlagKept)) == 0 &&
         hookIsFinite(head->vehicle_time_s) && hookIsState(head->hook_state) &&
         hookIsAnswer(head->answer);
}

bool hookDecodeTickReadings(const GliderDictionary* dictionary, const HookFrame* frame,
                            const HookSubscribe* subscription, HookTickReadings* readings) {
  HookByteReader in = hookPayloadOf(frame);
  hookSkip(&in, kHeadBytes);
  const uint32_t count = countOf(subscription);
  BitMap reported = {{0}};
  BitMap with_value = {{0}};
  if (frame->type != kHookMessageTypeTick || !readMap(&in, count, &reported) ||
      !readMap(&in, count, &with_value)) {
    return false;
  }
  for (uint32_t i = 0; i < count; ++i) {
    const uint16_t id = subscription->sensors[i].id;
    readings->told[i] = !hasBit(&reported, i)    ? kHookReadingReportNothing
                        : hasBit(&with_value, i) ? kHookReadingReportValue
                                                 : kHookReadingReportUnchanged;
    if (hasBit(&with_value, i)) {
      if (!hasBit(&reported, i)) {
        return false;
      }
      const uint32_t width = hookSensorWidth(dictionary, id);
      readings->values[i] = hookFromWire(width, hookRead(&in, width));
    }
  }
  return hookIsAllRead(&in);
}
