// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#define GLIDER_DEFINE_DICTIONARY
#include "hooks/hookbeh/hull.h"
#include "hooks/protocol/sensor_list.h"
#include "hooks/protocol/tick.h"
#include "platforms/slocum_sensors.h"

/// The Slocum as the hooks of its own software have it, and the protocol as this vehicle speaks it.
namespace glider::hooks {

inline constexpr Hull kHull{GLIDER_HULL_GREATEST_DEPTH_M,
                            GLIDER_HULL_STEEPEST_PITCH_RAD,
                            GLIDER_HULL_SHALLOWEST_PITCH_RAD,
                            GLIDER_HULL_VERTICAL_RATE_M_S,
                            GLIDER_HULL_PUMP_CC,
                            GLIDER_HULL_FIN_RAD,
                            GLIDER_HULL_BATTERY_IN};

inline uint32_t sensorWidth(uint16_t id) {
  return sensorWidth(gliderDictionary, id);
}
inline bool isScienceSensor(uint16_t id) {
  return isScienceSensor(gliderDictionary, id);
}
inline bool isInstructionSensor(uint16_t id) {
  return isInstructionSensor(gliderDictionary, id);
}
inline bool appendValue(Frame& frame, const SensorValue& value) {
  return appendValue(gliderDictionary, frame, value);
}
[[nodiscard]] inline bool decodeList(const Frame& frame, SensorList& list) {
  return decodeList(gliderDictionary, frame, list);
}
[[nodiscard]] inline bool decode(const Frame& frame, Subscribe& subscribe) {
  return decode(gliderDictionary, frame, subscribe);
}
[[nodiscard]] inline bool decode(const Frame& frame, const Subscribe& subscription,
                                 TickReadings& readings) {
  return decode(gliderDictionary, frame, subscription, readings);
}
inline void encode(const TickHead& head, const Subscribe& subscription,
                   const TickReadings& readings, Frame& frame) {
  encode(gliderDictionary, head, subscription, readings, frame);
}

}  // namespace glider::hooks
