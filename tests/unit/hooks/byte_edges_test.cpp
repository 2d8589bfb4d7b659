// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Bytes, queues, lists and frames at the very edge of their limits: the last that fits, the first
// that does not.

#include "hooks/protocol/bytes.h"
#include "hooks/protocol/crc.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/send_queue.h"
#include "hooks/protocol/sensor_list.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/line_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

namespace glider::hooks {
namespace {

TEST(Bytes, AWriterFillsItsArrayAndNoByteMore) {
  uint8_t bytes[9] = {0, 0, 0, 0, 0, 0, 0, 0xAA, 0xBB};
  ByteWriter out(bytes, 7);
  out.u24(0x030201);
  out.u32(0x07060504);
  EXPECT_TRUE(out.fits());
  EXPECT_EQ(out.size(), 7U);
  out.u8(9);
  EXPECT_FALSE(out.fits());
  EXPECT_EQ(out.size(), 7U);
  for (uint8_t i = 0; i < 7; ++i) {
    EXPECT_EQ(bytes[i], i + 1);
  }
  EXPECT_EQ(bytes[7], 0xAA);
  ByteWriter one_short(bytes, 3);
  one_short.u16(1);
  one_short.u16(2);
  EXPECT_FALSE(one_short.fits());
  EXPECT_EQ(one_short.size(), 2U) << "what does not fit is left out whole";
  one_short.u8(3);
  EXPECT_EQ(one_short.size(), 3U);
  EXPECT_FALSE(one_short.fits()) << "for good";
}

TEST(Bytes, AReaderStopsAtItsEnd) {
  const uint8_t bytes[] = {1, 2, 3, 4, 5, 6, 7, 8};
  ByteReader in(bytes, 4);
  EXPECT_EQ(in.u16(), 0x0201);
  EXPECT_FALSE(in.exact());
  EXPECT_EQ(in.u16(), 0x0403);
  EXPECT_TRUE(in.exact());
  EXPECT_EQ(in.u8(), 0);
  EXPECT_FALSE(in.good());
  EXPECT_FALSE(in.exact());
  ByteReader torn(bytes, 4);
  EXPECT_EQ(torn.u8(), 1);
  EXPECT_EQ(torn.u32(), 0U) << "3 bytes are not a number of 4";
  EXPECT_FALSE(torn.good());
  EXPECT_EQ(torn.u8(), 0) << "nor is what is left of them one";
  ByteReader skipping(bytes, 4);
  skipping.skip(3);
  EXPECT_TRUE(skipping.good());
  EXPECT_EQ(skipping.u8(), 4);
  skipping.skip(1);
  EXPECT_FALSE(skipping.good());
  ByteReader far(bytes, 4);
  (void)far.u16();
  far.skip(3);
  EXPECT_FALSE(far.good()) << "2 are left";
  EXPECT_EQ(far.u8(), 0) << "nor is anything read behind the end";
  ByteReader all(bytes, 4);
  all.skip(4);
  EXPECT_TRUE(all.exact());
  ByteReader never(bytes, 4);
  never.skip(5);
  never.skip(0);
  EXPECT_FALSE(never.good()) << "nor is it good again";
}

/// A stream that takes as many bytes as the test says.
struct Taker {
  std::vector<uint8_t> got;
  int32_t takes = 0;
  GliderByteStream stream() {
    return {this, nullptr, [](void* self, const uint8_t* bytes, uint32_t count) {
              auto* taker = static_cast<Taker*>(self);
              if (taker->takes > 0) {
                const auto kept = std::min(count, static_cast<uint32_t>(taker->takes));
                taker->got.insert(taker->got.end(), bytes, bytes + kept);
              }
              return taker->takes;
            }};
  }
};

Frame frameOf(uint16_t size, uint8_t fill) {
  Frame frame;
  frame.type = MessageType::Write;
  frame.size = size;
  std::memset(frame.payload, fill, size);
  return frame;
}

TEST(SendQueue, TakesAFrameThatJustFits) {
  // A payload of 100 takes at most 100 + 6, a byte for each 254 begun and the end.
  EXPECT_EQ(encodedBound(100), 108U);
  EXPECT_EQ(encodedBound(247), 255U);
  EXPECT_EQ(encodedBound(248), 257U);
  EXPECT_EQ(encodedBound(502), 512U);
  SendQueue just;
  EXPECT_TRUE(just.empty());
  EXPECT_EQ(just.room(), 2048U);
  for (int i = 0; i < 7; ++i) {
    EXPECT_TRUE(just.add(frameOf(240, 7)));
  }
  SendQueue too_small = just;
  EXPECT_TRUE(just.add(frameOf(196, 7)));
  EXPECT_EQ(just.room(), 108U);
  EXPECT_TRUE(just.add(frameOf(100, 7)));
  EXPECT_FALSE(just.empty());
  EXPECT_EQ(just.room(), 0U);
  EXPECT_FALSE(just.add(frameOf(0, 7)));
  EXPECT_TRUE(too_small.add(frameOf(197, 7)));
  EXPECT_EQ(too_small.room(), 107U);
  EXPECT_FALSE(too_small.add(frameOf(100, 7)));
  EXPECT_EQ(too_small.room(), 107U);
}

TEST(SendQueue, HandsOverPartByPart) {
  SendQueue queue;
  ASSERT_TRUE(queue.add(frameOf(20, 1)));
  ASSERT_TRUE(queue.add(frameOf(30, 2)));
  const uint32_t waiting = 2048 - queue.room();
  Taker line;
  line.takes = 0;
  EXPECT_TRUE(queue.flush(line.stream())) << "a full line is not a failure";
  EXPECT_EQ(queue.room(), 2048 - waiting);
  line.takes = 1;
  EXPECT_TRUE(queue.flush(line.stream())) << "byte by byte";
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.room(), 2048U);
  ASSERT_EQ(line.got.size(), waiting);
  FrameDecoder decoder;
  std::vector<uint16_t> sizes;
  for (const uint8_t byte : line.got) {
    if (decoder.push(byte)) {
      sizes.push_back(decoder.frame().size);
    }
  }
  EXPECT_EQ(sizes, (std::vector<uint16_t>{20, 30}));
}

TEST(SendQueue, GoesOnWhereTheLineStopped) {
  SendQueue queue;
  ASSERT_TRUE(queue.add(frameOf(20, 1)));
  Taker line;
  // The line takes 5 bytes, then none.
  const auto five_then_none = [](void* self, const uint8_t* bytes, uint32_t) -> int32_t {
    auto* taker = static_cast<Taker*>(self);
    if (taker->got.size() % 5 == 0 && taker->takes-- > 0) {
      taker->got.insert(taker->got.end(), bytes, bytes + 5);
      return 5;
    }
    return 0;
  };
  for (int i = 0; i < 6; ++i) {
    line.takes = 1;
    EXPECT_TRUE(queue.flush({&line, nullptr, five_then_none}));
    line.takes = 0;
  }
  // 28 bytes wait at first; the sixth handful would go past the end of them.
  FrameDecoder decoder;
  int whole = 0;
  for (const uint8_t byte : line.got) {
    whole += decoder.push(byte) ? 1 : 0;
  }
  EXPECT_EQ(whole, 1);
}

TEST(SendQueue, AStreamThatTakesTooMuchOrFailsDoesNoHarm) {
  SendQueue queue;
  ASSERT_TRUE(queue.add(frameOf(20, 1)));
  Taker line;
  line.takes = 1000;  // says that it took more than there was
  EXPECT_TRUE(queue.flush(line.stream()));
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.room(), 2048U);
  ASSERT_TRUE(queue.add(frameOf(20, 1)));
  line.takes = -1;
  EXPECT_FALSE(queue.flush(line.stream()));
  EXPECT_FALSE(queue.empty()) << "what waits is kept";
  line.takes = 5;
  line.got.clear();
  EXPECT_TRUE(queue.flush(line.stream()));
  EXPECT_EQ(line.got.size(), 28U);
  EXPECT_TRUE(queue.flush(line.stream())) << "of nothing";
}

TEST(SendQueue, WhatWentBeforeTheLineFailedDoesNotGoAgain) {
  SendQueue queue;
  ASSERT_TRUE(queue.add(frameOf(20, 1)));
  std::vector<uint8_t> got;
  const GliderByteStream fails{&got, nullptr,
                               [](void* self, const uint8_t* bytes, uint32_t) -> int32_t {
                                 auto* taken = static_cast<std::vector<uint8_t>*>(self);
                                 if (!taken->empty()) {
                                   return -1;
                                 }
                                 taken->assign(bytes, bytes + 8);
                                 return 8;
                               }};
  EXPECT_FALSE(queue.flush(fails));
  EXPECT_EQ(queue.room(), 2048U - 20);
  Taker line;
  line.takes = 1000;
  EXPECT_TRUE(queue.flush(line.stream()));
  got.insert(got.end(), line.got.begin(), line.got.end());
  FrameDecoder decoder;
  int whole = 0;
  for (const uint8_t byte : got) {
    whole += decoder.push(byte) ? 1 : 0;
  }
  EXPECT_EQ(whole, 1);
}

TEST(SensorList, HoldsExactlyItsBytesInEachWidth) {
  // 250 bytes: the count, then two for the number and the width of each.
  for (const auto& [id, width] : std::map<uint16_t, uint32_t>{
           {GLIDER_X_HOOK_STATE, 1}, {GLIDER_M_DEPTH, 4}, {GLIDER_M_LAT, 8}}) {
    ASSERT_EQ(sensorWidth(id), width);
    Frame frame;
    encodeEmptyList(frame);
    uint32_t count = 0;
    while (appendValue(frame, {id, 1})) {
      ++count;
      ASSERT_LE(frame.size, 250);
    }
    EXPECT_EQ(count, 249 / (2 + width));
    EXPECT_EQ(frame.size, 1 + count * (2 + width)) << "what does not fit leaves no trace";
    EXPECT_EQ(frame.payload[0], count);
    SensorList list;
    EXPECT_TRUE(decodeList(frame, list));
    EXPECT_EQ(list.count, count);
  }
  // 1 + 22 * 10 + 4 * 6 + 3 = 248, and 1 + 24 * 10 + 3 * 3 = 250: to the last byte.
  Frame full;
  encodeEmptyList(full);
  for (int i = 0; i < 24; ++i) {
    ASSERT_TRUE(appendValue(full, {GLIDER_M_LAT, 1}));
  }
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(appendValue(full, {GLIDER_X_HOOK_STATE, 1}));
  }
  EXPECT_EQ(full.size, 250);
  EXPECT_FALSE(appendValue(full, {GLIDER_X_HOOK_STATE, 1}));
  SensorList list;
  EXPECT_TRUE(decodeList(full, list));
  full.size = 251;
  EXPECT_FALSE(decodeList(full, list));
}

TEST(SensorList, ACountThatIsNotTheListsIsRefused) {
  Frame frame;
  encodeEmptyList(frame);
  ASSERT_TRUE(appendValue(frame, {GLIDER_M_DEPTH, 1}));
  SensorList list;
  ASSERT_TRUE(decodeList(frame, list));
  frame.payload[0] = 2;
  EXPECT_FALSE(decodeList(frame, list));
  frame.payload[0] = 0;
  EXPECT_FALSE(decodeList(frame, list));
  frame.payload[0] = 1;
  frame.type = MessageType::Tick;
  EXPECT_FALSE(decodeList(frame, list));
  encodeEmptyList(frame);
  EXPECT_TRUE(decodeList(frame, list));
  EXPECT_EQ(list.count, 0U);
  frame.payload[1] = 0xFF;
  frame.payload[2] = 0xFF;
  frame.payload[0] = 1;
  frame.size = 3;
  EXPECT_FALSE(decodeList(frame, list)) << "no such sensor";
}

TEST(SensorList, MoreBytesThanAListMayHaveOrMoreValuesAreRefused) {
  Frame frame;
  encodeEmptyList(frame);
  while (appendValue(frame, {GLIDER_X_HOOK_STATE, 1})) {
  }
  SensorList list;
  EXPECT_TRUE(decodeList(frame, list));
  EXPECT_EQ(list.count, 83U);
  ++frame.payload[0];
  EXPECT_FALSE(decodeList(frame, list)) << "one is missing";
  frame.payload[0] = 25;
  for (uint32_t i = 0; i < 25; ++i) {
    frame.payload[1 + 10 * i] = GLIDER_M_LAT & 0xFF;
    frame.payload[2 + 10 * i] = GLIDER_M_LAT >> 8;
  }
  frame.size = 251;
  EXPECT_FALSE(decodeList(frame, list)) << "a byte too much";
}

/// These bytes, stuffed as frames are, with an end.
std::vector<uint8_t> stuffed(const std::vector<uint8_t>& plain) {
  std::vector<uint8_t> out{0};
  size_t code = 0;
  const auto close = [&] {
    out[code] = static_cast<uint8_t>(out.size() - code);
    code = out.size();
    out.push_back(0);
  };
  for (const uint8_t byte : plain) {
    if (out.size() - code == 255) {
      close();
    }
    if (byte == 0) {
      close();
    } else {
      out.push_back(byte);
    }
  }
  close();
  return out;
}

/// The bytes of a frame before they are stuffed, its check included.
std::vector<uint8_t> plain(MessageType type, uint32_t payload, uint32_t check_bytes) {
  std::vector<uint8_t> bytes(2 + payload, 7);
  bytes[0] = static_cast<uint8_t>(type);
  const auto size = static_cast<uint32_t>(bytes.size());
  const uint32_t check = check_bytes == 2
                             ? crc16(bytes.data() + 2, size - 2, crc16(bytes.data(), 2))
                             : crc32c(bytes.data() + 2, size - 2, crc32c(bytes.data(), 2));
  for (uint32_t i = 0; i < check_bytes; ++i) {
    bytes.push_back(static_cast<uint8_t>(check >> (8 * i)));
  }
  return bytes;
}

bool isTaken(const std::vector<uint8_t>& bytes) {
  FrameDecoder decoder;
  bool good = false;
  for (const uint8_t byte : stuffed(bytes)) {
    good = decoder.push(byte);
  }
  return good;
}

TEST(FrameEdges, IsAtMostAsLongAsItMayBeWithAnyCheck) {
  std::vector<uint8_t> longest = plain(MessageType::Write, kMostPayload, 4);
  EXPECT_TRUE(isTaken(longest));
  longest.push_back(7);
  EXPECT_FALSE(isTaken(longest)) << "a byte behind a good frame";
  EXPECT_FALSE(isTaken(plain(MessageType::Write, kMostPayload + 1, 4)));
  EXPECT_TRUE(isTaken(plain(MessageType::Beacon, kMostPayload, 2)));
  EXPECT_FALSE(isTaken(plain(MessageType::Beacon, kMostPayload + 1, 2))) << "its check is shorter";
  EXPECT_FALSE(isTaken(plain(MessageType::Beacon, kMostPayload + 2, 2)));
}

TEST(FrameEdges, IsAtLeastItsHeadAndCheck) {
  EXPECT_TRUE(isTaken(plain(MessageType::Write, 0, 4)));
  EXPECT_TRUE(isTaken(plain(MessageType::Beacon, 0, 2)));
  for (const MessageType type : {MessageType::Write, MessageType::Beacon}) {
    std::vector<uint8_t> bytes = plain(type, 0, 4);
    while (!bytes.empty()) {
      bytes.pop_back();
      EXPECT_FALSE(isTaken(bytes)) << bytes.size();
    }
  }
}

TEST(FrameEdges, AnEqualCheckWithAnotherNumberIsAnotherFrame) {
  // Two Beacons of one length with one CRC-16 and different sequences.
  Frame one;
  encode(Beacon{}, one);
  one.sequence = 1;
  uint8_t bytes[kMostEncodedBytes];
  const auto check = [&](const Frame& frame) {
    FrameDecoder decoder;
    uint8_t plain[kMostFrameBytes] = {static_cast<uint8_t>(frame.type), frame.sequence};
    std::memcpy(plain + 2, frame.payload, frame.size);
    uint16_t crc = 0xFFFF;
    for (uint32_t i = 0; i < frame.size + 2U; ++i) {
      crc = static_cast<uint16_t>(crc ^ (plain[i] << 8));
      for (int bit = 0; bit < 8; ++bit) {
        crc = static_cast<uint16_t>((crc & 0x8000) != 0 ? (crc << 1) ^ 0x1021 : crc << 1);
      }
    }
    return crc;
  };
  Frame other = one;
  other.sequence = 2;
  const uint16_t wanted = check(one);
  bool found = false;
  for (uint32_t filling = 0; filling < 65536 && !found; ++filling) {
    other.payload[2] = static_cast<uint8_t>(filling);
    other.payload[3] = static_cast<uint8_t>(filling >> 8U);
    found = check(other) == wanted;
  }
  ASSERT_TRUE(found);
  FrameDecoder decoder;
  const auto whole = [&](const Frame& frame) {
    const uint32_t size = encodeFrame(frame, bytes);
    bool good = false;
    for (uint32_t i = 0; i < size; ++i) {
      good = decoder.push(bytes[i]);
    }
    return good;
  };
  EXPECT_TRUE(whole(one));
  EXPECT_TRUE(whole(other));
  EXPECT_EQ(decoder.frame().sequence, 2);
  EXPECT_FALSE(whole(other));
  EXPECT_EQ(decoder.doubles(), 1U);
}

}  // namespace
}  // namespace glider::hooks
