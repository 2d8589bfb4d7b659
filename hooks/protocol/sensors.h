// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The sensors of the vehicle as numbers on the line: see platforms/slocum.toml.
namespace glider::hooks {

/// One sensor with its value, in the vehicle's unit.
struct SensorValue {
  uint16_t id = 0;  ///< number in the platform file
  double value = 0;
};

/// What the SBC wants to hear of a sensor.
struct Subscription {
  uint16_t id = 0;
  uint8_t every = 1;    ///< at most once in so many flight cycles, 1…255
  float dead_band = 0;  ///< a value within so much of the one that the SBC holds is not sent
};

uint16_t sensorCount();
/// Bytes that sensor `id` takes in the sensor array and on the line: 1 (int8), 4 (float32), 8
/// (float64); 0: no such one.
uint32_t sensorWidth(uint16_t id);
/// True when the science computer has sensor `id`; false for the flight controller's and unknown
/// ones.
bool isScienceSensor(uint16_t id);
/// True for the sensors that make an instruction (`sci_hook_session` … `sci_hook_sequence`): all
/// that the SBC may write.
bool isInstructionSensor(uint16_t id);
/// As the platform file has it: unless it says otherwise, every report, exactly.
Subscription usualSubscription(uint16_t id);
/// The bits of `value` in the width of sensor `id`, as they go on the line: one NaN, and of a
/// 1-byte sensor whole numbers in -127…127, -128 for NaN.
uint64_t toWire(uint16_t id, double value);
double fromWire(uint16_t id, uint64_t bits);
/// The number that both ends compare before they trust each other's sensor numbers.
uint32_t dictionaryHash();

}  // namespace glider::hooks
