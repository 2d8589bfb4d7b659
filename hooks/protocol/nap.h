// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_NAP_H
#define GLIDER_HOOKS_PROTOCOL_NAP_H

#include "hooks/protocol/tick.h"

/// What the SBC orders before it sleeps: how long the vehicle keeps its Ticks, and what in them
/// wakes it earlier (README.md, "Naps").
#ifdef __cplusplus
enum class HookNapKind : uint8_t {
#define NAP_KIND(name, number) name = number,
#include "hooks/protocol/nap.def"
};
#else
typedef uint8_t HookNapKind;
enum {
#define NAP_KIND(name, number) kHookNapKind##name = number,
#include "hooks/protocol/nap.def"
};
#endif

GLIDER_HOOKS_BEGIN

enum { kHookMostNapConditions = 32 };

/// A report of a subscribed sensor that ends the nap.
typedef struct HookNapCondition {
  uint16_t id GLIDER_IS(0);  ///< the sensor's number in the platform file
  HookNapKind kind GLIDER_IS(HookNapKind::AtLeast);
  double value GLIDER_IS(0);  ///< in the vehicle's unit; 0 with Known; s with Quiet
} HookNapCondition;

typedef struct HookNap {
  uint8_t wake_s GLIDER_IS(0);     ///< from the wake signal until the SBC reads its line, s
  uint16_t length_s GLIDER_IS(1);  ///< s of vehicle time from the Tick that is answered, 1…65535
  uint8_t count GLIDER_IS(0);      ///< of the conditions, at most kHookMostNapConditions
  HookNapCondition conditions[kHookMostNapConditions];
} HookNap;

void hookEncodeNap(const HookNap* nap, HookFrame* frame);
/// Also false if a condition is about a sensor that `subscription` does not have. What `nap` then
/// holds has no meaning.
bool hookDecodeNap(const HookFrame* frame, const HookSubscribe* subscription, HookNap* nap);

/// Whether the report of `value`, as the SBC decodes it, ends the nap by `condition`. That there is
/// no report (Quiet) is for others to notice.
bool hookNapConditionHolds(const HookNapCondition* condition, double value);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using Nap = HookNap;
using NapCondition = HookNapCondition;
using NapKind = HookNapKind;
inline constexpr uint32_t kMostNapConditions = kHookMostNapConditions;

inline void encode(const Nap& nap, Frame& frame) {
  hookEncodeNap(&nap, &frame);
}
[[nodiscard]] inline bool decode(const Frame& frame, const Subscribe& subscription, Nap& nap) {
  return hookDecodeNap(&frame, &subscription, &nap);
}
}  // namespace glider::hooks
#endif

#endif
