// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/dictionary.h"

#include <stdint.h>

/// The sensors of the vehicle as numbers on the line, according to the vehicle's dictionary.
namespace glider::hooks {

/// One sensor with its value, in the vehicle's unit.
struct SensorValue {
  uint16_t id = 0;  ///< number in the platform file
  double value = 0;
};

/// How the SBC subscribes to a sensor.
struct Subscription {
  uint16_t id = 0;
  uint8_t every = 1;    ///< at most once in this many flight cycles, 1…255
  float dead_band = 0;  ///< a value this close to the one that the SBC holds is not sent
};

/// No sensor has this number.
inline constexpr uint16_t kNoSensor = UINT16_MAX;

/// The number of the sensor with this role, kNoSensor if the vehicle has none.
uint16_t sensorOf(const GliderDictionary& dictionary, GliderRole role);
/// Bytes that sensor `id` takes in the sensor array and on the line: 1 (int8), 4 (float32), 8
/// (float64); 0: no such sensor.
uint32_t sensorWidth(const GliderDictionary& dictionary, uint16_t id);
/// True when the science computer has sensor `id`; false for the flight controller's and unknown
/// ones.
bool isScienceSensor(const GliderDictionary& dictionary, uint16_t id);
/// True for the sensors that form an instruction (`sci_hook_session` … `sci_hook_sequence`): all
/// that the SBC may write.
bool isInstructionSensor(const GliderDictionary& dictionary, uint16_t id);
/// The subscription from the platform file; its default is every report with its exact value.
Subscription usualSubscription(const GliderDictionary& dictionary, uint16_t id);
/// The bits of `value` in `width` bytes (sensorWidth), as they go on the line: one NaN, and in 1
/// byte whole numbers in -127…127, -128 for NaN.
uint64_t toWire(uint32_t width, double value);
double fromWire(uint32_t width, uint64_t bits);

}  // namespace glider::hooks
