// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/frame.h"

#include "hooks/protocol/crc.h"
#include "tests/unit/hooks/examples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <vector>

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

TEST(Frame, CrcsAreThoseOfTheCatalogue) {
  const auto* text = reinterpret_cast<const uint8_t*>("123456789");
  EXPECT_EQ(crc16(text, 9), 0x29B1);
  EXPECT_EQ(crc16(nullptr, 0), 0xFFFF);
  EXPECT_EQ(crc32c(text, 9), 0xE3069283U);
  EXPECT_EQ(crc32c(nullptr, 0), 0U);
  EXPECT_EQ(crc32c(text + 4, 5, crc32c(text, 4)), 0xE3069283U) << "in two pieces";
  EXPECT_EQ(crc16(text + 4, 5, crc16(text, 4)), 0x29B1) << "in two pieces";
  const uint8_t zeros[32] = {};
  EXPECT_EQ(crc32c(zeros, 32), 0x8A9136AAU) << "the example of RFC 3720";
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
      frame.size = static_cast<uint16_t>(size);
      for (uint32_t i = 0; i < size; ++i) {
        frame.payload[i] = kind == 0   ? uint8_t{0}
                           : kind == 1 ? uint8_t{255}
                           : kind == 2 ? static_cast<uint8_t>(i % 3)
                                       : static_cast<uint8_t>(random());
      }
      uint8_t bytes[kMostEncodedBytes];
      const uint32_t count = encodeFrame(frame, bytes);
      ASSERT_LE(count, encodedBound(size));
      ASSERT_LE(encodedBound(size), kMostEncodedBytes);
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

TEST(Frame, ADoubleIsPassedOverAndCounted) {
  FrameDecoder decoder;
  const auto examples = exampleFrames();
  uint32_t good = 0;
  for (int round = 0; round < 3; ++round) {  // the same numbers again, but not one after the other
    for (const auto& [name, frame] : examples) {
      uint8_t bytes[kMostEncodedBytes];
      const uint32_t size = encodeFrame(frame, bytes);
      for (int copy = 0; copy < 2; ++copy) {
        for (uint32_t i = 0; i < size; ++i) {
          good += decoder.push(bytes[i]) ? 1U : 0U;
        }
      }
    }
  }
  EXPECT_EQ(good, 3 * examples.size());
  EXPECT_EQ(decoder.doubles(), 3 * examples.size());
  EXPECT_EQ(decoder.badFrames(), 0U);
}

TEST(Frame, ALongerFrameThanAnyIsRefused) {
  // As a later version might send it: right in every other way.
  std::vector<uint8_t> plain(kMostFrameBytes + 1, 7);
  plain[0] = static_cast<uint8_t>(MessageType::Tick);
  const uint32_t check = crc32c(plain.data(), kMostFrameBytes - 3);
  for (uint32_t i = 0; i < 4; ++i) {
    plain[kMostFrameBytes - 3 + i] = static_cast<uint8_t>(check >> (8 * i));
  }
  FrameDecoder decoder;
  for (size_t at = 0; at < plain.size(); at += 254) {
    const size_t group = std::min<size_t>(254, plain.size() - at);
    decoder.push(static_cast<uint8_t>(group + 1));
    for (size_t i = 0; i < group; ++i) {
      ASSERT_NE(plain[at + i], 0);
      decoder.push(plain[at + i]);
    }
  }
  EXPECT_FALSE(decoder.push(0));
  EXPECT_EQ(decoder.badFrames(), 1U);
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
