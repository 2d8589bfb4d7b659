// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A share of what tests/fuzz/imc_fuzzer.cpp does; scripts/soak/imc does more.

#include "tests/fuzz/imc_hostile.h"

#include "tests/unit/hooks/imc_described.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace glider::imc_hostile {
namespace {

using imc_described::described;
using imc_described::payloadOf;
using imc_described::randomLeaves;

uint32_t packets() {
  const char* const given = std::getenv("GLIDER_IMC_PACKETS");
  return given != nullptr ? static_cast<uint32_t>(std::atoi(given)) : 10000;
}

/// A packet of a random message, perhaps damaged.
Bytes anyPacket(std::mt19937& random) {
  static const std::map<uint16_t, std::string> messages = described();
  const uint16_t id =
      std::next(messages.begin(), static_cast<std::ptrdiff_t>(random() % messages.size()))->first;
  const ByteOrder order = random() % 4 == 0 ? ByteOrder::Big : ByteOrder::Little;
  const double time = random() % 8 == 0 ? 0 : 1.79e9 + static_cast<double>(random() % 1000);
  Bytes bytes = imc_described::packetOf(id, {.time_s = time, .source = 0xD1},
                                        payloadOf(id, randomLeaves(id, random), order), order);
  switch (random() % 6) {
    case 0:
      bytes.resize(random() % bytes.size());
      break;
    case 1:
      bytes[random() % bytes.size()] ^= static_cast<uint8_t>(1U << random() % 8);
      break;
    case 2:  // its size
      bytes[4 + random() % 2] = static_cast<uint8_t>(random() % 5);
      break;
    default:
      break;
  }
  return bytes;
}

TEST(ImcHostile, StreamsAreReadAsASlowReaderReadsThem) {
  std::mt19937 random(5);
  for (uint32_t done = 0; done < packets(); done += 8) {
    Bytes stream;
    for (int i = 0; i < 8; ++i) {
      const Bytes packet = anyPacket(random);
      stream.insert(stream.end(), packet.begin(), packet.end());
      for (auto n = random() % 12; n > 8; --n) {
        stream.push_back(static_cast<uint8_t>(random() % 3 == 0   ? 0x54
                                              : random() % 2 == 0 ? 0xFE
                                                                  : random()));
      }
    }
    requireReader(stream, 1 + random() % 300);
  }
}

TEST(ImcHostile, PayloadsOfAnyBytes) {
  std::mt19937 random(6);
  for (uint32_t done = 0; done < packets(); ++done) {
    Bytes payload(random() % 64);
    for (uint8_t& byte : payload) {
      byte = static_cast<uint8_t>(random() % 3 == 0 ? random() : random() % 3);
    }
    requireDecoders(payload);
  }
}

/// Real payloads with a byte changed get further than random ones.
TEST(ImcHostile, PayloadsWithAByteChanged) {
  std::mt19937 random(8);
  for (uint32_t done = 0; done < packets(); ++done) {
    const ByteOrder order = done % 2 == 0 ? ByteOrder::Little : ByteOrder::Big;
    constexpr uint16_t kDeep[] = {479, 480, 500, 551, 552, 559, 560};
    const uint16_t id = kDeep[done % std::size(kDeep)];
    Bytes payload = payloadOf(id, randomLeaves(id, random), order);
    payload[random() % payload.size()] = static_cast<uint8_t>(random());
    requireDecoders(payload);
  }
}

}  // namespace
}  // namespace glider::imc_hostile
