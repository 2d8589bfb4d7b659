// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/janus/packet.h"

namespace glider::hooks::janus {
namespace {

constexpr uint32_t kByteBits = 8;
constexpr uint32_t kChecked = kPacketBytes - 1;

// From the least significant bit of the first 56.
constexpr uint32_t kApplicationAt = kBlockBits;
constexpr uint32_t kClassAt = 40;
constexpr uint32_t kForwardsAt = 48;
constexpr uint32_t kHearsAt = 49;
constexpr uint32_t kScheduledAt = 50;
constexpr uint32_t kMobileAt = 51;
constexpr uint32_t kVersionAt = 52;

/// CRC-8 with the polynomial x^8 + x^2 + x + 1, from 0, the most significant bit first.
uint8_t check(const uint8_t* bytes, uint32_t count) {
  constexpr uint32_t kPolynomial = 0x07, kTop = 0x80;
  uint32_t sum = 0;
  for (uint32_t i = 0; i < count; ++i) {
    sum ^= bytes[i];
    for (uint32_t bit = 0; bit < kByteBits; ++bit) {
      sum = ((sum << 1U) ^ ((sum & kTop) != 0 ? kPolynomial : 0)) & 0xFFU;
    }
  }
  return static_cast<uint8_t>(sum);
}

uint64_t flag(bool set, uint32_t at) {
  return uint64_t{set ? 1U : 0U} << at;
}

bool isSet(uint64_t bits, uint32_t at) {
  return (bits >> at & 1U) != 0;
}

}  // namespace

bool encode(const Packet& packet, uint8_t* bytes) {
  if (packet.application > kMostApplication || packet.block > kMostBlock) {
    return false;
  }
  const uint64_t bits = uint64_t{kVersion} << kVersionAt | flag(packet.mobile, kMobileAt) |
                        flag(packet.scheduled, kScheduledAt) | flag(packet.hears, kHearsAt) |
                        flag(packet.forwards, kForwardsAt) | uint64_t{packet.class_id} << kClassAt |
                        uint64_t{packet.application} << kApplicationAt | packet.block;
  for (uint32_t i = 0; i < kChecked; ++i) {
    bytes[i] = static_cast<uint8_t>(bits >> (kByteBits * (kChecked - 1 - i)) & 0xFFU);
  }
  bytes[kChecked] = check(bytes, kChecked);
  return true;
}

bool decode(const uint8_t* bytes, Packet& packet) {
  uint64_t bits = 0;
  for (uint32_t i = 0; i < kChecked; ++i) {
    bits = bits << kByteBits | bytes[i];
  }
  if (bits >> kVersionAt != kVersion || check(bytes, kChecked) != bytes[kChecked]) {
    return false;
  }
  packet.mobile = isSet(bits, kMobileAt);
  packet.scheduled = isSet(bits, kScheduledAt);
  packet.hears = isSet(bits, kHearsAt);
  packet.forwards = isSet(bits, kForwardsAt);
  packet.class_id = static_cast<uint8_t>(bits >> kClassAt & 0xFFU);
  packet.application = static_cast<uint32_t>(bits >> kApplicationAt & kMostApplication);
  packet.block = bits & kMostBlock;
  return true;
}

}  // namespace glider::hooks::janus
