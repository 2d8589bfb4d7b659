// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/memory.h"

#include <gtest/gtest.h>

#include <vector>

namespace glider::hooks {
namespace {

TEST(MemoryLine, CarriesBytesBothWaysInOrder) {
  MemoryLine line;
  const GliderByteStream left = line.left();
  const GliderByteStream right = line.right();
  const uint8_t words[] = {1, 0, 2};
  EXPECT_EQ(left.write(left.self, words, 3), 3);
  EXPECT_EQ(right.write(right.self, words + 1, 2), 2);
  uint8_t got[8] = {};
  EXPECT_EQ(right.read(right.self, got, 2), 2);
  EXPECT_EQ(got[0], 1);
  EXPECT_EQ(right.read(right.self, got, 8), 1);
  EXPECT_EQ(got[0], 2);
  EXPECT_EQ(right.read(right.self, got, 8), 0);
  EXPECT_EQ(left.read(left.self, got, 8), 2);
}

TEST(MemoryLine, TakesNoMoreThanItHolds) {
  MemoryLine line;
  const GliderByteStream left = line.left();
  const GliderByteStream right = line.right();
  std::vector<uint8_t> many(MemoryLine::kCapacity + 100, 7);
  EXPECT_EQ(left.write(left.self, many.data(), static_cast<uint32_t>(many.size())),
            static_cast<int32_t>(MemoryLine::kCapacity));
  EXPECT_EQ(left.write(left.self, many.data(), 1), 0);
  EXPECT_EQ(right.read(right.self, many.data(), 10), 10);
  EXPECT_EQ(left.write(left.self, many.data(), 100), 10);
}

TEST(MemoryLine, ClosedShowsAfterTheLastByte) {
  MemoryLine line;
  const GliderByteStream left = line.left();
  const GliderByteStream right = line.right();
  const uint8_t byte = 5;
  EXPECT_EQ(left.write(left.self, &byte, 1), 1);
  line.close();
  uint8_t got = 0;
  EXPECT_EQ(right.read(right.self, &got, 1), 1);
  EXPECT_EQ(right.read(right.self, &got, 1), kGliderStreamClosed);
  EXPECT_EQ(right.write(right.self, &got, 1), kGliderStreamClosed);
}

}  // namespace
}  // namespace glider::hooks
