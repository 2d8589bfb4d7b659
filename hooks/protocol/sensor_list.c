// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/sensor_list.h"

#include "hooks/protocol/payload.h"

void hookEncodeEmptyList(HookFrame* frame) {
  HookByteWriter out = hookStartPayload(frame, kHookMessageTypeWrite);
  hookWriteU8(&out, 0);
  hookFinishPayload(frame, &out);
}

bool hookAppendValue(const GliderDictionary* dictionary, HookFrame* frame,
                     const HookSensorValue* value) {
  const uint32_t width = hookSensorWidth(dictionary, value->id);
  if (width == 0 || frame->size + 2 + width > kHookMostListPayload) {
    return false;
  }
  HookByteWriter out = hookWriterTo(frame->payload + frame->size, 2 + width);
  hookWriteU16(&out, value->id);
  hookWrite(&out, hookToWire(width, value->value), width);
  frame->size = (uint16_t)(frame->size + out.size);
  ++frame->payload[0];
  return true;
}

bool hookDecodeList(const GliderDictionary* dictionary, const HookFrame* frame,
                    HookSensorList* list) {
  list->count = 0;
  if (frame->type != kHookMessageTypeWrite || frame->size > kHookMostListPayload) {
    return false;
  }
  HookByteReader in = hookPayloadOf(frame);
  const uint8_t count = hookReadU8(&in);
  for (uint32_t i = 0; i < count && i < kHookMostListed && in.good; ++i) {
    HookSensorValue* value = &list->values[i];
    value->id = hookReadU16(&in);
    const uint32_t width = hookSensorWidth(dictionary, value->id);
    if (width == 0) {
      return false;
    }
    value->value = hookFromWire(width, hookRead(&in, width));
    ++list->count;
  }
  return hookIsAllRead(&in) && list->count == count;
}
