// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/sensor_list.h"

#include "hooks/protocol/payload.h"

namespace glider::hooks {

void encodeEmptyList(Frame& frame) {
  ByteWriter out = startPayload(frame, MessageType::Write);
  out.u8(0);
  finishPayload(frame, out);
}

bool appendValue(const GliderDictionary& dictionary, Frame& frame, const SensorValue& value) {
  const uint32_t width = sensorWidth(dictionary, value.id);
  if (width == 0 || frame.size + 2 + width > kMostListPayload) {
    return false;
  }
  ByteWriter out(frame.payload + frame.size, 2 + width);
  out.u16(value.id);
  out.bits(toWire(width, value.value), width);
  frame.size = static_cast<uint16_t>(frame.size + out.size());
  ++frame.payload[0];
  return true;
}

bool decodeList(const GliderDictionary& dictionary, const Frame& frame, SensorList& list) {
  list.count = 0;
  if (frame.type != MessageType::Write || frame.size > kMostListPayload) {
    return false;
  }
  ByteReader in = payloadOf(frame);
  const uint8_t count = in.u8();
  for (uint32_t i = 0; i < count && i < kMostListed && in.good(); ++i) {
    SensorValue& value = list.values[i];
    value.id = in.u16();
    const uint32_t width = sensorWidth(dictionary, value.id);
    if (width == 0) {
      return false;
    }
    value.value = fromWire(width, in.bits(width));
    ++list.count;
  }
  return in.exact() && list.count == count;
}

}  // namespace glider::hooks
