// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/link/serial_line.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace glider::simulator {
namespace {

int32_t write(GliderByteStream stream, size_t count) {
  const std::vector<uint8_t> bytes(count, 0x55);
  return stream.write(stream.self, bytes.data(), static_cast<uint32_t>(count));
}

int32_t readAll(GliderByteStream stream) {
  std::array<uint8_t, 8192> bytes;
  return stream.read(stream.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
}

TEST(SerialLine, TakesTenBitsAByte) {
  SerialLine line(9600);
  EXPECT_EQ(write(line.left(), 960), 960);
  EXPECT_EQ(readAll(line.right()), 0);
  line.setNow(0.5);
  EXPECT_EQ(readAll(line.right()), 480);
  line.setNow(0.5 + 0.9 / 960);
  EXPECT_EQ(readAll(line.right()), 0) << "the next byte is still on the wire";
  line.setNow(1.001);
  EXPECT_EQ(readAll(line.right()), 480);
  EXPECT_EQ(readAll(line.left()), 0) << "nothing comes back";
}

TEST(SerialLine, QueuesBehindWhatIsUnderWayAndRefusesWhenFull) {
  SerialLine line(115200);
  EXPECT_EQ(write(line.right(), 5000), static_cast<int32_t>(SerialLine::kCapacity));
  EXPECT_EQ(write(line.right(), 1), 0);
  line.setNow(0.1);
  EXPECT_EQ(readAll(line.left()), 1152);
  EXPECT_EQ(write(line.right(), 1152), 1152);
  line.setNow(0.1 + 4096.0 / 11520 - 1e-6);
  EXPECT_EQ(readAll(line.left()), 4095);
  line.setNow(10);
  EXPECT_EQ(readAll(line.left()), 1);
}

TEST(SerialLine, BothDirectionsAreIndependent) {
  SerialLine line(9600);
  write(line.left(), 96);
  write(line.right(), 96);
  line.setNow(0.1001);
  EXPECT_EQ(readAll(line.left()), 96);
  EXPECT_EQ(readAll(line.right()), 96);
}

}  // namespace
}  // namespace glider::simulator
