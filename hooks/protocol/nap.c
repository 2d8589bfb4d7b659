// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/nap.h"

#include "hooks/protocol/payload.h"

enum { kHeadBytes = 4, kConditionBytes = 11 };

GLIDER_STATIC_ASSERT(LargestNapFits,
                     kHeadBytes + kHookMostNapConditions * kConditionBytes <= kHookMostPayload);

void hookEncodeNap(const HookNap* nap, HookFrame* frame) {
  const uint32_t count = nap->count < kHookMostNapConditions ? nap->count : kHookMostNapConditions;
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeNap);
  hookWriteU8(&out, nap->wake_s);
  hookWriteU16(&out, nap->length_s);
  hookWriteU8(&out, count);
  for (uint32_t i = 0; i < count; ++i) {
    const HookNapCondition* condition = &nap->conditions[i];
    hookWriteU16(&out, condition->id);
    hookWriteU8(&out, condition->kind);
    hookWriteF64(&out, condition->kind == kHookNapKindKnown ? 0 : condition->value);
  }
  hookFinishPayload(frame, &out);
}

static bool isSubscribed(const HookSubscribe* subscription, uint16_t id) {
  for (uint32_t i = 0; i < subscription->count && i < kHookMostSubscriptions; ++i) {
    if (subscription->sensors[i].id == id) {
      return true;
    }
  }
  return false;
}

static bool isCondition(const HookSubscribe* subscription, const HookNapCondition* condition) {
  const bool has_value = condition->value == condition->value;
  return isSubscribed(subscription, condition->id) && condition->kind <= kHookNapKindQuiet &&
         (has_value || condition->kind == kHookNapKindKnown);
}

bool hookDecodeNap(const HookFrame* frame, const HookSubscribe* subscription, HookNap* nap) {
  HookByteReader in = hookPayloadOf(frame);
  nap->wake_s = hookReadU8(&in);
  nap->length_s = hookReadU16(&in);
  nap->count = hookReadU8(&in);
  if (frame->type != kHookMessageTypeNap || nap->length_s == 0 ||
      nap->count > kHookMostNapConditions) {
    return false;
  }
  for (uint32_t i = 0; i < nap->count; ++i) {
    HookNapCondition* condition = &nap->conditions[i];
    condition->id = hookReadU16(&in);
    condition->kind = hookReadU8(&in);
    condition->value = hookReadF64(&in);
    if (!isCondition(subscription, condition)) {
      return false;
    }
  }
  return hookIsAllRead(&in);
}

bool hookNapConditionHolds(const HookNapCondition* condition, double value) {
  switch (condition->kind) {
    case kHookNapKindAtLeast:
      return value >= condition->value;
    case kHookNapKindAtMost:
      return value <= condition->value;
    case kHookNapKindQuiet:
      return value != value;
    default:
      return value == value;
  }
}
