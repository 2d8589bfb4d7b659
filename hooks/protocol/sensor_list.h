// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_SENSOR_LIST_H
#define GLIDER_HOOKS_PROTOCOL_SENSOR_LIST_H

#include "hooks/protocol/frame.h"
#include "hooks/protocol/sensors.h"

/// Lists of sensors with their values: a Write of the SBC.
GLIDER_HOOKS_BEGIN

enum {
  /// Lists are shorter than a frame may be: an instruction takes 93 bytes.
  kHookMostListPayload = 250,
  /// More values than any list can hold (1-byte sensors).
  kHookMostListed = kHookMostListPayload / 3
};

typedef struct HookSensorList {
  uint32_t count GLIDER_IS(0);
  HookSensorValue values[kHookMostListed];
} HookSensorList;

/// An empty Write: append to it with hookAppendValue.
void hookEncodeEmptyList(HookFrame* frame);
/// Appends one value in the sensor's width. False, with nothing changed, when it does not fit or
/// there is no such sensor.
bool hookAppendValue(const GliderDictionary* dictionary, HookFrame* frame,
                     const HookSensorValue* value);
/// Of a Write.
bool hookDecodeList(const GliderDictionary* dictionary, const HookFrame* frame,
                    HookSensorList* list);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using SensorList = HookSensorList;
inline constexpr uint32_t kMostListPayload = kHookMostListPayload, kMostListed = kHookMostListed;

inline void encodeEmptyList(Frame& frame) {
  hookEncodeEmptyList(&frame);
}
inline bool appendValue(const GliderDictionary& dictionary, Frame& frame,
                        const SensorValue& value) {
  return hookAppendValue(&dictionary, &frame, &value);
}
[[nodiscard]] inline bool decodeList(const GliderDictionary& dictionary, const Frame& frame,
                                     SensorList& list) {
  return hookDecodeList(&dictionary, &frame, &list);
}
}  // namespace glider::hooks
#endif

#endif
