// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_SENSORS_H
#define GLIDER_HOOKS_PROTOCOL_SENSORS_H

#include "hooks/protocol/dictionary.h"
#include "hooks/protocol/language.h"

/// The sensors of the vehicle as numbers on the line, according to the vehicle's dictionary.
GLIDER_HOOKS_BEGIN

/// One sensor with its value, in the vehicle's unit.
typedef struct HookSensorValue {
  uint16_t id GLIDER_IS(0);  ///< number in the platform file
  double value GLIDER_IS(0);
} HookSensorValue;

/// How the SBC subscribes to a sensor.
typedef struct HookSubscription {
  uint16_t id GLIDER_IS(0);
  uint8_t every GLIDER_IS(1);    ///< at most once in this many flight cycles, 1…255
  float dead_band GLIDER_IS(0);  ///< a value this close to the one that the SBC holds is not sent
} HookSubscription;

/// No sensor has this number.
enum { kHookNoSensor = UINT16_MAX };

/// The number of the sensor with this role, kHookNoSensor if the vehicle has none.
uint16_t hookSensorOf(const GliderDictionary* dictionary, GliderRole role);
/// Bytes that sensor `id` takes in the sensor array and on the line: 1 (int8), 4 (float32), 8
/// (float64); 0: no such sensor.
uint32_t hookSensorWidth(const GliderDictionary* dictionary, uint16_t id);
/// True when the science computer has sensor `id`; false for the flight controller's and unknown
/// ones.
bool hookIsScienceSensor(const GliderDictionary* dictionary, uint16_t id);
/// True for the sensors that form an instruction (`sci_hook_session` … `sci_hook_sequence`): all
/// that the SBC may write.
bool hookIsInstructionSensor(const GliderDictionary* dictionary, uint16_t id);
/// The subscription from the platform file; its default is every report with its exact value.
void hookUsualSubscription(const GliderDictionary* dictionary, uint16_t id,
                           HookSubscription* subscription);
/// The bits of `value` in `width` bytes (hookSensorWidth), as they go on the line: one NaN, and in
/// 1 byte whole numbers in -127…127, -128 for NaN.
uint64_t hookToWire(uint32_t width, double value);
double hookFromWire(uint32_t width, uint64_t bits);

GLIDER_HOOKS_END

#ifdef __cplusplus
namespace glider::hooks {
using SensorValue = HookSensorValue;
using Subscription = HookSubscription;
inline constexpr uint16_t kNoSensor = kHookNoSensor;

inline uint16_t sensorOf(const GliderDictionary& dictionary, GliderRole role) {
  return hookSensorOf(&dictionary, role);
}
inline uint32_t sensorWidth(const GliderDictionary& dictionary, uint16_t id) {
  return hookSensorWidth(&dictionary, id);
}
inline bool isScienceSensor(const GliderDictionary& dictionary, uint16_t id) {
  return hookIsScienceSensor(&dictionary, id);
}
inline bool isInstructionSensor(const GliderDictionary& dictionary, uint16_t id) {
  return hookIsInstructionSensor(&dictionary, id);
}
inline uint64_t toWire(uint32_t width, double value) {
  return hookToWire(width, value);
}
inline double fromWire(uint32_t width, uint64_t bits) {
  return hookFromWire(width, bits);
}
}  // namespace glider::hooks
#endif

#endif
