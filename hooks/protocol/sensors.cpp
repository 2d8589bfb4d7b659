// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/sensors.h"

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

uint32_t dictionaryHash() {
  return GLIDER_DICTIONARY_HASH;
}

}  // namespace glider::hooks
