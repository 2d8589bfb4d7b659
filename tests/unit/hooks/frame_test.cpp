// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/frame.h"

#include "tests/unit/hooks/examples.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

namespace glider::hooks {
namespace {

std::string hex(const uint8_t* bytes, uint32_t count) {
  std::string text;
  for (uint32_t i = 0; i < count; ++i) {
    char pair[4];
    std::snprintf(pair, sizeof pair, "%s%02x", i == 0 ? "" : " ", bytes[i]);
    text += pair;
  }
  return text;
}

/// The block of README.md between "```frames" and "```": name → bytes.
std::map<std::string, std::string> documentedFrames() {
  std::ifstream in(GLIDER_SOURCE_DIR "/hooks/protocol/README.md");
  std::map<std::string, std::string> frames;
  std::string line;
  std::string name;
  bool inside = false;
  while (std::getline(in, line)) {
    if (line.starts_with("```")) {
      inside = line == "```frames";
      continue;
    }
    if (!inside || line.empty()) {
      continue;
    }
    std::istringstream words(line);
    if (line[0] != ' ') {
      words >> name;
    }
    std::string word;
    while (words >> word) {
      frames[name] += (frames[name].empty() ? "" : " ") + word;
    }
  }
  return frames;
}

TEST(Frame, CrcIsCcittFalse) {
  const char* text = "123456789";
  EXPECT_EQ(crc16(reinterpret_cast<const uint8_t*>(text), 9), 0x29B1);
  EXPECT_EQ(crc16(nullptr, 0), 0xFFFF);
}

TEST(Frame, ReadmeShowsTheVeryBytes) {
  auto documented = documentedFrames();
  for (const auto& [name, frame] : exampleFrames()) {
    uint8_t bytes[kMostEncodedBytes];
    const uint32_t size = encodeFrame(frame, bytes);
    EXPECT_EQ(documented[name], hex(bytes, size)) << name;
    documented.erase(name);
  }
  EXPECT_TRUE(documented.empty());
}

TEST(Frame, EveryLengthAndContentComesBack) {
  std::mt19937 random(1);
  for (uint32_t size = 0; size <= kMostPayload; ++size) {
    for (int kind = 0; kind < 4; ++kind) {
      Frame frame;
      frame.type = MessageType::Write;
      frame.sequence = static_cast<uint8_t>(size * 7);
      frame.size = static_cast<uint8_t>(size);
      for (uint32_t i = 0; i < size; ++i) {
        frame.payload[i] = kind == 0   ? uint8_t{0}
                           : kind == 1 ? uint8_t{255}
                           : kind == 2 ? static_cast<uint8_t>(i % 3)
                                       : static_cast<uint8_t>(random());
      }
      uint8_t bytes[kMostEncodedBytes];
      const uint32_t count = encodeFrame(frame, bytes);
      ASSERT_LE(count, kMostEncodedBytes);
      FrameDecoder decoder;
      for (uint32_t i = 0; i + 1 < count; ++i) {
        ASSERT_NE(bytes[i], 0);
        ASSERT_FALSE(decoder.push(bytes[i]));
      }
      ASSERT_TRUE(decoder.push(0));
      ASSERT_EQ(decoder.frame().size, size);
      ASSERT_EQ(decoder.frame().sequence, frame.sequence);
      ASSERT_EQ(decoder.frame().type, MessageType::Write);
      ASSERT_EQ(std::memcmp(decoder.frame().payload, frame.payload, size), 0);
      ASSERT_EQ(decoder.badFrames(), 0U);
    }
  }
}

TEST(Frame, AnyZeroByteResynchronises) {
  uint8_t bytes[kMostEncodedBytes];
  const uint32_t size = encodeFrame(exampleFrames()[0].second, bytes);
  FrameDecoder decoder;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(decoder.push(static_cast<uint8_t>(1 + i % 255)));  // endless noise
  }
  EXPECT_FALSE(decoder.push(0));
  EXPECT_EQ(decoder.badFrames(), 1U);
  for (uint32_t i = 0; i < 4; ++i) {
    EXPECT_FALSE(decoder.push(bytes[i]));  // cut off
  }
  EXPECT_FALSE(decoder.push(0));
  EXPECT_EQ(decoder.badFrames(), 2U);
  EXPECT_FALSE(decoder.push(0));  // empty ones do not count
  EXPECT_EQ(decoder.badFrames(), 2U);
  bool whole = false;
  for (uint32_t i = 0; i < size; ++i) {
    whole = decoder.push(bytes[i]);
  }
  EXPECT_TRUE(whole);
}

TEST(Frame, EveryFlippedBitAndLostByteIsNoticed) {
  for (const auto& [name, frame] : exampleFrames()) {
    uint8_t good[kMostEncodedBytes];
    const uint32_t size = encodeFrame(frame, good);
    for (uint32_t at = 0; at + 1 < size; ++at) {
      for (int bit = 0; bit < 9; ++bit) {
        FrameDecoder decoder;
        bool whole = false;
        for (uint32_t i = 0; i < size; ++i) {
          if (i == at && bit == 8) {
            continue;
          }
          const auto flip = static_cast<uint8_t>(i == at ? 1U << bit : 0U);
          whole |= decoder.push(static_cast<uint8_t>(good[i] ^ flip));
        }
        EXPECT_FALSE(whole) << name << " byte " << at << " bit " << bit;
      }
    }
  }
}

TEST(Frame, UnknownTypesAreRefused) {
  Frame frame;
  frame.type = static_cast<MessageType>(0x7F);
  uint8_t bytes[kMostEncodedBytes];
  const uint32_t size = encodeFrame(frame, bytes);
  FrameDecoder decoder;
  for (uint32_t i = 0; i < size; ++i) {
    EXPECT_FALSE(decoder.push(bytes[i]));
  }
  EXPECT_EQ(decoder.badFrames(), 1U);
}

}  // namespace
}  // namespace glider::hooks
