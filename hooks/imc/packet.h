// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Packets of IMC (Inter-Module Communication, LSTS): a header, the payload, a CRC.
namespace glider::hooks::imc {

/// The order of the bytes of a packet's numbers: that of its sender.
enum class ByteOrder : uint8_t { Little, Big };

/// The first number of a packet; its bytes tell the order.
inline constexpr uint16_t kSync = 0xFE54;
inline constexpr uint32_t kHeaderBytes = 20;
inline constexpr uint32_t kCrcBytes = 2;
/// The longest payload that is read or written. Those of our messages are shorter than half of it,
/// unless a vehicle's texts are long.
inline constexpr uint32_t kMostPayload = 1024;
inline constexpr uint32_t kMostPacket = kHeaderBytes + kMostPayload + kCrcBytes;

/// Who sends a packet to whom, and when.
struct Header {
  double time_s = 0;  ///< since 1970 (UTC), by the clock of the sender
  uint16_t source = 0;
  uint8_t source_entity = 0;
  uint16_t destination = 0;
  uint8_t destination_entity = 0;
};

/// A packet with the right CRC, of any message.
struct Packet {
  uint16_t id = 0;
  Header header;
  ByteOrder order = ByteOrder::Little;
  const uint8_t* payload = nullptr;
  uint32_t size = 0;  ///< of the payload
};

/// The number in `width` bytes, at most 8.
inline uint64_t numberAt(const uint8_t* bytes, uint32_t width, ByteOrder order) {
  uint64_t value = 0;
  for (uint32_t i = 0; i < width; ++i) {
    value = value << 8U | bytes[order == ByteOrder::Big ? i : width - 1 - i];
  }
  return value;
}

}  // namespace glider::hooks::imc
