// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_files/data_file.h"

#include <expected>
#include <string_view>
#include <vector>

namespace glider::slocum {

/// The sensors of a vehicle that its data files contain, in the order of their values.
struct SensorList {
  std::vector<Sensor> sensors;
  size_t lines = 0;  ///< with those of the sensors that the files do not contain
  uint32_t crc = 0;  ///< of the text
  size_t end = 0;    ///< where the text ends
};

/// Reads the lines `s: T 12 4 4 name unit` from `begin` on: `count` lines, or all if it is 0.
std::expected<SensorList, Damage> parseSensorList(std::string_view content, size_t begin,
                                                  size_t count);

/// The checksum by which files name their list: CRC-32 (reflected, 0xEDB88320) without the final
/// inversion.
uint32_t sensorListCrc(std::string_view text);

}  // namespace glider::slocum
