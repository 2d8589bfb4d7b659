// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/sensors.h"

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/numbers.h"

static uint8_t toByte(double value) {
  const int whole = value != value ? -128 : value >= 127 ? 127 : value <= -127 ? -127 : (int)value;
  return (uint8_t)whole;
}

static double fromByte(uint8_t byte) {
  const int whole = (byte ^ 0x80) - 0x80;  // in two's complement
  return whole == -128 ? hookUnknown() : whole;
}

/// The sensor's row, null if there is none: values are kept for at most GLIDER_MOST_SENSORS
/// sensors, even if the dictionary has more.
static const GliderSensorFormat* rowOf(const GliderDictionary* dictionary, uint16_t id) {
  return id < dictionary->count && id < GLIDER_MOST_SENSORS ? &dictionary->sensors[id] : NULL;
}

uint16_t hookSensorOf(const GliderDictionary* dictionary, GliderRole role) {
  const uint32_t number = dictionary->roles[role];
  return number < dictionary->count && number < GLIDER_MOST_SENSORS ? (uint16_t)number
                                                                    : kHookNoSensor;
}

uint32_t hookSensorWidth(const GliderDictionary* dictionary, uint16_t id) {
  const GliderSensorFormat* row = rowOf(dictionary, id);
  return row != NULL ? row->bytes : 0;
}

bool hookIsScienceSensor(const GliderDictionary* dictionary, uint16_t id) {
  const GliderSensorFormat* row = rowOf(dictionary, id);
  return row != NULL && row->science != 0;
}

bool hookIsInstructionSensor(const GliderDictionary* dictionary, uint16_t id) {
  for (uint32_t role = kGliderRoleHookSession; role <= kGliderRoleHookSampling; ++role) {
    if (id != kHookNoSensor && hookSensorOf(dictionary, (GliderRole)role) == id) {
      return true;
    }
  }
  return false;
}

void hookUsualSubscription(const GliderDictionary* dictionary, uint16_t id,
                           HookSubscription* subscription) {
  const GliderSensorFormat* row = rowOf(dictionary, id);
  subscription->id = id;
  subscription->every = row != NULL ? (uint8_t)row->every : 1;
  subscription->dead_band = row != NULL ? (float)row->dead_band : 0;
}

uint64_t hookToWire(uint32_t width, double value) {
  switch (width) {
    case 1:
      return toByte(value);
    case 4:
      return hookBitsOfFloat((float)value);
    default:
      return hookBitsOfDouble(value);
  }
}

double hookFromWire(uint32_t width, uint64_t bits) {
  switch (width) {
    case 1:
      return fromByte((uint8_t)bits);
    case 4:
      return (double)hookFloatOf((uint32_t)bits);
    default:
      return hookDoubleOf(bits);
  }
}
