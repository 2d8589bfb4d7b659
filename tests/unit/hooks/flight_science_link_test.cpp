// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/flight_science_link/flight_science_link.h"

#include "hooks/protocol/messages.h"
#include "hooks/transport/memory.h"
#include "tests/slocum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace glider::hooks {
namespace {

std::vector<SensorUpdate> drain(FlightScienceLink& end, const GliderByteStream& stream,
                                uint32_t capacity = 16) {
  std::vector<SensorUpdate> all;
  std::vector<SensorUpdate> some(capacity);
  uint32_t count = 0;
  do {
    count = end.poll(stream, some.data(), capacity);
    all.insert(all.end(), some.begin(), some.begin() + count);
  } while (count == capacity);
  return all;
}

std::vector<SensorUpdate> flightCycle() {
  std::vector<SensorUpdate> cycle;
  for (uint16_t id = 0; id < GLIDER_SENSOR_COUNT; ++id) {
    if (!isScienceSensor(id) && id != GLIDER_M_PRESENT_SECS_INTO_MISSION &&
        id != GLIDER_M_CYCLE_NUMBER) {
      cycle.push_back({id, 1});
    }
  }
  cycle.push_back({GLIDER_M_PRESENT_SECS_INTO_MISSION, 4});
  cycle.push_back({GLIDER_M_CYCLE_NUMBER, 1});
  return cycle;
}

TEST(FlightScienceLink, UpdatesArriveInOrderWithAnyCapacity) {
  for (const uint32_t capacity : {1U, 3U, 128U}) {
    MemoryLine line;
    FlightScienceLink flight{gliderDictionary};
    FlightScienceLink science{gliderDictionary};
    const auto cycle = flightCycle();
    ASSERT_TRUE(flight.send(cycle.data(), static_cast<uint32_t>(cycle.size())));
    EXPECT_TRUE(drain(flight, line.left()).empty());
    const auto got = drain(science, line.right(), capacity);
    ASSERT_EQ(got.size(), cycle.size());
    for (size_t i = 0; i < got.size(); ++i) {
      EXPECT_EQ(got[i].id, cycle[i].id);
      EXPECT_EQ(got[i].value, cycle[i].value);
    }
  }
}

TEST(FlightScienceLink, ALineThatTakesAFewBytesAtATimeGetsNoOthers) {
  struct Slow {
    std::vector<uint8_t> took;
    uint32_t most = 0;  // that it was offered
  } slow;
  const GliderByteStream stream{&slow, [](void*, uint8_t*, uint32_t) { return 0; },
                                [](void* self, const uint8_t* bytes, uint32_t count) {
                                  auto& line = *static_cast<Slow*>(self);
                                  line.most = std::max(line.most, count);
                                  const uint32_t taken = std::min(count, 7U);
                                  line.took.insert(line.took.end(), bytes, bytes + taken);
                                  return static_cast<int32_t>(taken);
                                }};
  FlightScienceLink flight{gliderDictionary};
  const SensorUpdate update{GLIDER_M_DEPTH, 12.5};
  ASSERT_TRUE(flight.send(&update, 1));
  EXPECT_TRUE(drain(flight, stream).empty());
  EXPECT_EQ(slow.took.size(), slow.most) << "all that it was offered at first, and no more";
  MemoryLine line;
  const GliderByteStream left = line.left();
  left.write(left.self, slow.took.data(), static_cast<uint32_t>(slow.took.size()));
  FlightScienceLink science{gliderDictionary};
  const auto got = drain(science, line.right());
  ASSERT_EQ(got.size(), 1U);
  EXPECT_EQ(got[0].value, 12.5);
}

TEST(FlightScienceLink, AWholeFlightCycleTakesAThirdOfASecond) {
  MemoryLine line;
  FlightScienceLink flight{gliderDictionary};
  const auto cycle = flightCycle();
  ASSERT_TRUE(flight.send(cycle.data(), static_cast<uint32_t>(cycle.size())));
  drain(flight, line.left());
  std::vector<uint8_t> bytes(4096);
  const GliderByteStream right = line.right();
  const int32_t count = right.read(right.self, bytes.data(), 4096);
  EXPECT_GT(count, 100);
  EXPECT_LT(count, 320) << "at 960 bytes/s";
}

TEST(FlightScienceLink, OneCallIsOneFrame) {
  // The second call of three does not fit behind the first: it must not be torn apart.
  MemoryLine line;
  FlightScienceLink flight{gliderDictionary};
  const std::vector<SensorUpdate> thirty(30, {GLIDER_M_DEPTH, 1});
  ASSERT_TRUE(flight.send(thirty.data(), 30));
  ASSERT_TRUE(flight.send(thirty.data(), 30));
  drain(flight, line.left());
  std::vector<uint8_t> bytes(4096);
  const GliderByteStream right = line.right();
  const int32_t count = right.read(right.self, bytes.data(), 4096);
  FrameDecoder decoder;
  std::vector<uint32_t> sizes;
  for (int32_t i = 0; i < count; ++i) {
    if (decoder.push(bytes[static_cast<size_t>(i)])) {
      SensorList list;
      ASSERT_TRUE(decodeList(decoder.frame(), list));
      sizes.push_back(list.count);
    }
  }
  EXPECT_EQ(sizes, (std::vector<uint32_t>{30, 30}));
}

TEST(FlightScienceLink, TheQueueIsBoundedAndTakesAllOrNothing) {
  FlightScienceLink flight{gliderDictionary};
  const std::vector<SensorUpdate> many(100, {GLIDER_M_DEPTH, 1});
  EXPECT_TRUE(flight.send(many.data(), 100));
  EXPECT_FALSE(flight.send(many.data(), 29));
  EXPECT_TRUE(flight.send(many.data(), 28));
  EXPECT_FALSE(flight.send(many.data(), 1));
}

TEST(FlightScienceLink, NoSuchSensorIsNotSent) {
  FlightScienceLink flight{gliderDictionary};
  const SensorUpdate wrong[] = {{GLIDER_M_DEPTH, 1}, {GLIDER_SENSOR_COUNT, 1}};
  EXPECT_FALSE(flight.send(wrong, 2));
  MemoryLine line;
  drain(flight, line.left());
  uint8_t byte = 0;
  const GliderByteStream right = line.right();
  EXPECT_EQ(right.read(right.self, &byte, 1), 0);
}

TEST(FlightScienceLink, NoiseAndStrangersAreCountedNotBelieved) {
  MemoryLine line;
  FlightScienceLink science{gliderDictionary};
  const GliderByteStream left = line.left();
  const uint8_t noise[] = {9, 8, 7, 0};
  left.write(left.self, noise, 4);
  Frame stranger;
  encode(Beacon{}, stranger);
  uint8_t bytes[kMostEncodedBytes];
  left.write(left.self, bytes, encodeFrame(stranger, bytes));
  EXPECT_TRUE(drain(science, line.right()).empty());
  EXPECT_EQ(science.badFrames(), 2U);
}

}  // namespace
}  // namespace glider::hooks
