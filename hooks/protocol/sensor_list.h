// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame.h"
#include "hooks/protocol/sensors.h"

#include <stdint.h>

/// Lists of sensors with their values: a Write of the SBC.
namespace glider::hooks {

/// Lists are shorter than a frame may be: an instruction takes 93 bytes.
inline constexpr uint32_t kMostListPayload = 250;
/// More values than any list can hold (1-byte sensors).
inline constexpr uint32_t kMostListed = kMostListPayload / 3;

struct SensorList {
  uint32_t count = 0;
  SensorValue values[kMostListed] = {};
};

/// An empty Write: append to it with appendValue.
void encodeEmptyList(Frame& frame);
/// Appends one value in the sensor's width. False, with nothing changed, when it does not fit or
/// there is no such sensor.
bool appendValue(const GliderDictionary& dictionary, Frame& frame, const SensorValue& value);
/// Of a Write.
[[nodiscard]] bool decodeList(const GliderDictionary& dictionary, const Frame& frame,
                              SensorList& list);

}  // namespace glider::hooks
