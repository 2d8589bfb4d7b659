// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The baseline packet of JANUS.

#include "hooks/janus/packet.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <string>

namespace glider::hooks::janus {
namespace {

using Bytes = std::array<uint8_t, kPacketBytes>;

std::string hexOf(const Bytes& bytes) {
  std::string text;
  for (const uint8_t byte : bytes) {
    char two[3];
    std::snprintf(two, sizeof two, "%02x", byte);
    text += two;
  }
  return text;
}

Bytes encoded(const Packet& packet) {
  Bytes bytes{};
  EXPECT_TRUE(encode(packet, bytes.data()));
  return bytes;
}

/// Of two independent computations of the published layout and check.
TEST(Janus, HasThePublishedLayout) {
  EXPECT_EQ(hexOf(encoded({})), "3a100000000000bf");
  Packet packet;
  packet.class_id = 66;
  packet.block = (uint64_t{1} << 33U) - 1;
  EXPECT_EQ(hexOf(encoded(packet)), "3a4201ffffffffb9");
}

/// Each field by its bits, of 1 the first sent.
TEST(Janus, EachFieldIsAtItsBits) {
  const auto bitsOf = [](const Packet& packet) {
    std::string bits;
    for (const uint8_t byte : encoded(packet)) {
      for (int bit = 7; bit >= 0; --bit) {
        bits += (byte >> bit & 1) != 0 ? '1' : '0';
      }
    }
    return bits;
  };
  Packet none;
  none.mobile = none.hears = false;
  none.class_id = 0;
  const std::string zero = bitsOf(none);
  EXPECT_EQ(zero.substr(0, 56), "0011" + std::string(52, '0'));
  const auto changed = [&](auto change) {
    Packet packet = none;
    change(packet);
    const std::string bits = bitsOf(packet);
    std::string places;
    for (size_t i = 0; i < 56; ++i) {
      places += bits[i] != zero[i] ? std::to_string(i + 1) + " " : "";
    }
    return places;
  };
  EXPECT_EQ(changed([](Packet& p) { p.mobile = true; }), "5 ");
  EXPECT_EQ(changed([](Packet& p) { p.scheduled = true; }), "6 ");
  EXPECT_EQ(changed([](Packet& p) { p.hears = true; }), "7 ");
  EXPECT_EQ(changed([](Packet& p) { p.forwards = true; }), "8 ");
  EXPECT_EQ(changed([](Packet& p) { p.class_id = 0x81; }), "9 16 ");
  EXPECT_EQ(changed([](Packet& p) { p.application = 33; }), "17 22 ");
  EXPECT_EQ(changed([](Packet& p) { p.block = (uint64_t{1} << 33U) | 1; }), "23 56 ");
}

TEST(Janus, IsReadAsItWasWritten) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 20000; ++i) {
    const uint64_t r = rng();
    const Packet packet{(r & 1U) != 0,
                        (r & 2U) != 0,
                        (r & 4U) != 0,
                        (r & 8U) != 0,
                        static_cast<uint8_t>(r >> 8U),
                        static_cast<uint32_t>(r >> 16U) % 64,
                        rng() & kMostBlock};
    Packet read;
    ASSERT_TRUE(decode(encoded(packet).data(), read));
    EXPECT_EQ(read.mobile, packet.mobile);
    EXPECT_EQ(read.scheduled, packet.scheduled);
    EXPECT_EQ(read.hears, packet.hears);
    EXPECT_EQ(read.forwards, packet.forwards);
    EXPECT_EQ(read.class_id, packet.class_id);
    EXPECT_EQ(read.application, packet.application);
    EXPECT_EQ(read.block, packet.block);
  }
}

/// One, two and three wrong bits in 64: this polynomial finds all of one and two.
TEST(Janus, DamageIsRefused) {
  Packet packet;
  packet.block = 0x2A5A5A5A5;
  const Bytes good = encoded(packet);
  Packet read;
  for (uint32_t i = 0; i < 64; ++i) {
    for (uint32_t j = i; j < 64; ++j) {
      Bytes bad = good;
      bad[i / 8] ^= static_cast<uint8_t>(1U << (i % 8));
      bad[j / 8] ^= static_cast<uint8_t>(i == j ? 0 : 1U << (j % 8));
      EXPECT_FALSE(decode(bad.data(), read)) << i << " " << j;
    }
  }
}

TEST(Janus, AnotherVersionIsRefused) {
  Bytes bytes = encoded({});
  for (uint32_t version = 0; version < 16; ++version) {
    bytes[0] = static_cast<uint8_t>(version << 4U | 0xAU);
    uint8_t sum = 0;  // its check is right
    for (uint32_t i = 0; i < 7; ++i) {
      sum = static_cast<uint8_t>(sum ^ bytes[i]);
      for (int bit = 0; bit < 8; ++bit) {
        sum = static_cast<uint8_t>(sum << 1U ^ ((sum & 0x80U) != 0 ? 0x07U : 0U));
      }
    }
    bytes[7] = sum;
    Packet read;
    EXPECT_EQ(decode(bytes.data(), read), version == kVersion) << version;
  }
}

TEST(Janus, WhatIsTooGreatIsNotWritten) {
  Bytes bytes{};
  Packet packet;
  packet.application = 64;
  EXPECT_FALSE(encode(packet, bytes.data()));
  packet.application = 63;
  packet.block = kMostBlock + 1;
  EXPECT_FALSE(encode(packet, bytes.data()));
  EXPECT_EQ(bytes, Bytes{});
  packet.block = kMostBlock;
  EXPECT_TRUE(encode(packet, bytes.data()));
}

}  // namespace
}  // namespace glider::hooks::janus
