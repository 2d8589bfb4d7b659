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
/// The number that both ends compare before they trust each other's sensor numbers.
uint32_t dictionaryHash();

}  // namespace glider::hooks
