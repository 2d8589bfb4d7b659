// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/sensors.h"

#include "hooks/protocol/bytes.h"
#include "platforms/slocum_sensors.h"

namespace glider::hooks {
namespace {

struct Row {
  uint8_t width;
  bool science;
};

constexpr Row kRows[] = {
#define SENSOR(number, name, bytes, science) {bytes, (science) != 0},
    GLIDER_SENSOR_LIST(SENSOR)
#undef SENSOR
};
static_assert(sizeof(kRows) / sizeof(kRows[0]) == GLIDER_SENSOR_COUNT);

constexpr Subscription kUsual[] = {
#define SENSOR(number, every, dead_band) {number, every, static_cast<float>(dead_band)},
    GLIDER_SENSOR_REPORTS(SENSOR)
#undef SENSOR
};
static_assert(sizeof(kUsual) / sizeof(kUsual[0]) == GLIDER_SENSOR_COUNT);

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

}  // namespace

uint16_t sensorCount() {
  return GLIDER_SENSOR_COUNT;
}

uint32_t sensorWidth(uint16_t id) {
  return id < GLIDER_SENSOR_COUNT ? kRows[id].width : 0;
}

bool isScienceSensor(uint16_t id) {
  return id < GLIDER_SENSOR_COUNT && kRows[id].science;
}

bool isInstructionSensor(uint16_t id) {
  switch (id) {
    case GLIDER_SCI_HOOK_SESSION:
    case GLIDER_SCI_HOOK_CONTROL:
    case GLIDER_SCI_HOOK_VERTICAL:
    case GLIDER_SCI_HOOK_DEPTH:
    case GLIDER_SCI_HOOK_PITCH:
    case GLIDER_SCI_HOOK_LATERAL:
    case GLIDER_SCI_HOOK_HEADING:
    case GLIDER_SCI_HOOK_LAT:
    case GLIDER_SCI_HOOK_LON:
    case GLIDER_SCI_HOOK_CHECK:
    case GLIDER_SCI_HOOK_SEQUENCE:
      return true;
    default:
      return false;
  }
}

Subscription usualSubscription(uint16_t id) {
  return id < GLIDER_SENSOR_COUNT ? kUsual[id] : Subscription{id};
}

uint64_t toWire(uint16_t id, double value) {
  switch (sensorWidth(id)) {
    case 1:
      return toByte(value);
    case 4:
      return bitsOf(static_cast<float>(value));
    default:
      return bitsOf(value);
  }
}

double fromWire(uint16_t id, uint64_t bits) {
  switch (sensorWidth(id)) {
    case 1:
      return fromByte(static_cast<uint8_t>(bits));
    case 4:
      return static_cast<double>(floatOf(static_cast<uint32_t>(bits)));
    default:
      return doubleOf(bits);
  }
}

uint32_t dictionaryHash() {
  return GLIDER_DICTIONARY_HASH;
}

}  // namespace glider::hooks
