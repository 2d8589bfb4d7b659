// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_TICK_H
#define GLIDER_HOOKS_PROTOCOL_TICK_H

#include "hooks/protocol/frame.h"
#include "hooks/protocol/sensors.h"
#include "hooks/protocol/values.h"

/// What the vehicle reports to the SBC, and how much of it: the messages Tick and Subscribe.
#ifdef __cplusplus
enum class HookReadingReport : uint8_t {
#define READING_REPORT(name) name,
#include "hooks/protocol/messages.def"
};
#else
typedef uint8_t HookReadingReport;
enum {
#define READING_REPORT(name) kHookReadingReport##name,
#include "hooks/protocol/messages.def"
};
#endif

GLIDER_HOOKS_BEGIN

enum { kHookMostSubscriptions = 64 };

typedef struct HookSubscribe {
  uint8_t count GLIDER_IS(0);
  HookSubscription sensors[kHookMostSubscriptions];
} HookSubscribe;

/// Head of a Tick.
typedef struct HookTickHead {
  bool virtual_time GLIDER_IS(false);
  bool kept GLIDER_IS(false);  ///< during a nap of the SBC; newer Ticks follow at once
  uint32_t link GLIDER_IS(0);
  double vehicle_time_s GLIDER_IS(0);  ///< from the 4-byte sensor m_present_secs_into_mission
  uint32_t cycle GLIDER_IS(0);         ///< at most 16777215, as are link and session
  uint16_t subscription GLIDER_IS(0);  ///< hookSubscriptionCheck of the list that is served
  HookState hook_state GLIDER_IS(HookState::Absent);
  HookAnswer answer GLIDER_IS(HookAnswer::None);
  uint16_t answered_sequence GLIDER_IS(0);
  uint32_t session GLIDER_IS(0);
  uint32_t clock_s GLIDER_IS(0);  ///< m_present_time, whole seconds since 1970; 0: unknown
} HookTickHead;

/// What a Tick reports about each subscribed sensor, in the subscription's order.
typedef struct HookTickReadings {
  HookReadingReport told[kHookMostSubscriptions] GLIDER_IS({});
  double values[kHookMostSubscriptions] GLIDER_IS({});  ///< of those that are reported by value
} HookTickReadings;

void hookEncodeSubscribe(const HookSubscribe* subscribe, HookFrame* frame);
/// Also false if it names a sensor that `dictionary` lacks.
bool hookDecodeSubscribe(const GliderDictionary* dictionary, const HookFrame* frame,
                         HookSubscribe* subscribe);
/// CRC-16 over the list as encoded in a Subscribe: shows whether both ends use the same list.
uint16_t hookSubscriptionCheck(const HookSubscribe* subscribe);

/// `readings` are those of `subscription`.
void hookEncodeTick(const GliderDictionary* dictionary, const HookTickHead* head,
                    const HookSubscribe* subscription, const HookTickReadings* readings,
                    HookFrame* frame);
/// The payload of a Tick of `subscription` that reports every sensor with a value, bytes.
uint32_t hookGreatestTick(const GliderDictionary* dictionary, const HookSubscribe* subscription);
/// In the payload of an encoded Tick: whether it is one of those that were kept.
void hookMarkTickKept(HookFrame* frame, bool kept);
/// The head alone: a receiver with a different subscription cannot read the rest.
bool hookDecodeTickHead(const HookFrame* frame, HookTickHead* head);
/// The rest; false if it does not match `subscription`.
bool hookDecodeTickReadings(const GliderDictionary* dictionary, const HookFrame* frame,
                            const HookSubscribe* subscription, HookTickReadings* readings);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using ReadingReport = HookReadingReport;
using Subscribe = HookSubscribe;
using TickHead = HookTickHead;
using TickReadings = HookTickReadings;
inline constexpr uint32_t kMostSubscriptions = kHookMostSubscriptions;

inline void encode(const Subscribe& subscribe, Frame& frame) {
  hookEncodeSubscribe(&subscribe, &frame);
}
[[nodiscard]] inline bool decode(const GliderDictionary& dictionary, const Frame& frame,
                                 Subscribe& subscribe) {
  return hookDecodeSubscribe(&dictionary, &frame, &subscribe);
}
inline uint16_t subscriptionCheck(const Subscribe& subscribe) {
  return hookSubscriptionCheck(&subscribe);
}
inline void encode(const GliderDictionary& dictionary, const TickHead& head,
                   const Subscribe& subscription, const TickReadings& readings, Frame& frame) {
  hookEncodeTick(&dictionary, &head, &subscription, &readings, &frame);
}
[[nodiscard]] inline bool decode(const Frame& frame, TickHead& head) {
  return hookDecodeTickHead(&frame, &head);
}
[[nodiscard]] inline bool decode(const GliderDictionary& dictionary, const Frame& frame,
                                 const Subscribe& subscription, TickReadings& readings) {
  return hookDecodeTickReadings(&dictionary, &frame, &subscription, &readings);
}
}  // namespace glider::hooks
#endif

#endif
