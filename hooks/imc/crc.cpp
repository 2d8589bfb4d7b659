// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/imc/crc.h"

namespace glider::hooks::imc {
namespace {

/// The CRC of each half byte; the reflected polynomial is 0xA001.
constexpr uint16_t kOfHalfByte[16] = {0x0000, 0xCC01, 0xD801, 0x1400, 0xF001, 0x3C00,
                                      0x2800, 0xE401, 0xA001, 0x6C00, 0x7800, 0xB401,
                                      0x5000, 0x9C01, 0x8801, 0x4400};

}  // namespace

uint16_t crc16Arc(const uint8_t* bytes, uint32_t count) {
  uint32_t crc = 0;
  for (uint32_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    crc = (crc >> 4U) ^ kOfHalfByte[crc & 15U];
    crc = (crc >> 4U) ^ kOfHalfByte[crc & 15U];
  }
  return static_cast<uint16_t>(crc);
}

}  // namespace glider::hooks::imc
