// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/sensors.h"

#include "hooks/protocol/bytes.h"

namespace glider::hooks {
namespace {

uint8_t toByte(double value) {
  const int whole = value != value  ? -128
                    : value >= 127  ? 127
                    : value <= -127 ? -127
                                    : static_cast<int>(value);
  return static_cast<uint8_t>(whole);
}

double fromByte(uint8_t byte) {
  const auto whole = static_cast<int8_t>(byte);
  return whole == -128 ? __builtin_nan("") : whole;
}

/// The sensor's row, null if there is none: values are kept for at most GLIDER_MOST_SENSORS
/// sensors, even if the dictionary has more.
const GliderSensorFormat* rowOf(const GliderDictionary& dictionary, uint16_t id) {
  return id < dictionary.count && id < GLIDER_MOST_SENSORS ? &dictionary.sensors[id] : nullptr;
}

}  // namespace

uint16_t sensorOf(const GliderDictionary& dictionary, GliderRole role) {
  const uint32_t number = dictionary.roles[role];
  return number < dictionary.count && number < GLIDER_MOST_SENSORS ? static_cast<uint16_t>(number)
                                                                   : kNoSensor;
}

uint32_t sensorWidth(const GliderDictionary& dictionary, uint16_t id) {
  const GliderSensorFormat* row = rowOf(dictionary, id);
  return row != nullptr ? row->bytes : 0;
}

bool isScienceSensor(const GliderDictionary& dictionary, uint16_t id) {
  const GliderSensorFormat* row = rowOf(dictionary, id);
  return row != nullptr && row->science != 0;
}

bool isInstructionSensor(const GliderDictionary& dictionary, uint16_t id) {
  for (uint32_t role = kGliderRoleHookSession; role <= kGliderRoleHookSequence; ++role) {
    if (id != kNoSensor && sensorOf(dictionary, static_cast<GliderRole>(role)) == id) {
      return true;
    }
  }
  return false;
}

Subscription usualSubscription(const GliderDictionary& dictionary, uint16_t id) {
  const GliderSensorFormat* row = rowOf(dictionary, id);
  return row != nullptr ? Subscription{id, static_cast<uint8_t>(row->every),
                                       static_cast<float>(row->dead_band)}
                        : Subscription{id};
}

uint64_t toWire(uint32_t width, double value) {
  switch (width) {
    case 1:
      return toByte(value);
    case 4:
      return bitsOf(static_cast<float>(value));
    default:
      return bitsOf(value);
  }
}

double fromWire(uint32_t width, uint64_t bits) {
  switch (width) {
    case 1:
      return fromByte(static_cast<uint8_t>(bits));
    case 4:
      return static_cast<double>(floatOf(static_cast<uint32_t>(bits)));
    default:
      return doubleOf(bits);
  }
}

}  // namespace glider::hooks
