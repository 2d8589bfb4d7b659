// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/crc.h"

namespace glider::hooks {
namespace {

constexpr uint32_t kReflectedCastagnoli = 0x82F63B78U;

/// CRC-32C of each half byte: small enough for any board, four times faster than bit by bit.
struct HalfByteTable {
  uint32_t of[16] = {};

  constexpr HalfByteTable() {
    for (uint32_t i = 0; i < 16; ++i) {
      uint32_t crc = i;
      for (int bit = 0; bit < 4; ++bit) {
        crc = (crc & 1U) != 0 ? (crc >> 1U) ^ kReflectedCastagnoli : crc >> 1U;
      }
      of[i] = crc;
    }
  }
};

constexpr HalfByteTable kTable;

}  // namespace

uint16_t crc16(const uint8_t* bytes, uint32_t count, uint16_t before) {
  uint32_t crc = before;
  for (uint32_t i = 0; i < count; ++i) {
    crc ^= static_cast<uint32_t>(bytes[i]) << 8U;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 0x8000U) != 0 ? (crc << 1U) ^ 0x1021U : crc << 1U;
    }
  }
  return static_cast<uint16_t>(crc);
}

uint32_t crc32c(const uint8_t* bytes, uint32_t count, uint32_t before) {
  uint32_t crc = ~before;
  for (uint32_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    crc = (crc >> 4U) ^ kTable.of[crc & 15U];
    crc = (crc >> 4U) ^ kTable.of[crc & 15U];
  }
  return ~crc;
}

}  // namespace glider::hooks
