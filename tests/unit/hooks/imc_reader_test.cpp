// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Finding packets in what arrives.

#include "hooks/imc/packet_reader.h"
#include "tests/unit/hooks/imc_streams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace glider::hooks::imc {
namespace {

using imc_described::packetOf;
using imc_samples::kSampleCount;
using imc_samples::kSamples;
using namespace imc_streams;

Bytes first(const Bytes& bytes, size_t count) {
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// A packet of an unknown message, with a payload of zeros.
Bytes packetOfSize(size_t payload, ByteOrder order = ByteOrder::Little) {
  return packetOf(999, kFromVehicle, Bytes(payload, 0), order);
}

TEST(ImcReader, GivesPacketsInTheirOrderForAnyPieces) {
  const Bytes all = allSamples();
  const AllFound whole = packetsIn(all);
  ASSERT_EQ(whole.size(), kSampleCount);
  for (uint32_t i = 0; i < kSampleCount; ++i) {
    EXPECT_EQ(whole[i].id, kSamples[i].id);
  }
  for (size_t piece = 1; piece < all.size(); ++piece) {
    ASSERT_EQ(packetsIn(all, piece), whole) << piece;
  }
}

TEST(ImcReader, APacketMayBeSplitAnywhere) {
  for (uint32_t i = 0; i < kSampleCount; ++i) {
    for (const ByteOrder order : kBothOrders) {
      const Bytes packet = sampleBytes(i, order);
      for (size_t cut = 0; cut <= packet.size(); ++cut) {
        PacketReader reader;
        AllFound found;
        read(&reader, first(packet, cut), SIZE_MAX, &found);
        ASSERT_EQ(found.size(), cut == packet.size() ? 1U : 0U) << kSamples[i].name << cut;
        read(&reader, Bytes(packet.begin() + static_cast<std::ptrdiff_t>(cut), packet.end()),
             SIZE_MAX, &found);
        ASSERT_EQ(found.size(), 1U) << kSamples[i].name << cut;
        ASSERT_EQ(found[0].id, kSamples[i].id);
        ASSERT_EQ(reader.held(), 0U);
      }
    }
  }
}

TEST(ImcReader, PacketsOfBothOrdersMayFollowEachOther) {
  const Bytes both = joined({sampleBytes(3, ByteOrder::Big), sampleBytes(4, ByteOrder::Little),
                             sampleBytes(5, ByteOrder::Big)});
  const AllFound found = packetsIn(both);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].order, ByteOrder::Big);
  EXPECT_EQ(found[1].order, ByteOrder::Little);
  EXPECT_EQ(found[2].order, ByteOrder::Big);
}

/// DUNE swallows what follows such bytes for many seconds. Here each packet of DUNE's order behind
/// them is given at once, with no bytes after it. One of the other order may have to wait for what
/// a false header states.
TEST(ImcReader, AFalseSyncHidesNoPacketBehindIt) {
  const Bytes garbage[] = {{0xFE, 0x54},
                           {0x54, 0xFE},
                           {0x54},
                           {0xFE},
                           {0x54, 0xFE, 0x54},
                           {0xFE, 0x54, 0xFE},
                           {0xFE, 0x54, 0x54, 0xFE},
                           {0xFE, 0x54, 0x00},
                           {0x54, 0xFE, 0x00},
                           {0x54, 0xFE, 0x96, 0x00, 0x00, 0x00},
                           {'x', 0xFE, 0x54, 'y'},
                           Bytes(40, 0x54),
                           Bytes(3000, 0xFE)};
  for (const Bytes& before : garbage) {
    for (uint32_t i = 0; i < kSampleCount; ++i) {
      for (const ByteOrder order : kBothOrders) {
        PacketReader reader;
        AllFound found;
        read(&reader, joined({before, sampleBytes(i, order)}), 1, &found);
        if (order == ByteOrder::Little) {
          ASSERT_EQ(found.size(), 1U) << kSamples[i].name << ::testing::PrintToString(before);
        }
        read(&reader, packetOfSize(kMostPayload), 1, &found);
        ASSERT_EQ(found.size(), 2U) << kSamples[i].name << ::testing::PrintToString(before);
        ASSERT_EQ(found[0].id, kSamples[i].id);
        ASSERT_EQ(reader.skippedBytes(), before.size());
      }
    }
  }
}

/// A false header that fits waits for as many bytes as it states. What lies inside is not lost, and
/// comes in its order.
TEST(ImcReader, PacketsInsideAFalseOneAreFound) {
  for (const ByteOrder order : kBothOrders) {
    for (const size_t size : {size_t{0}, size_t{60}, size_t{200}, size_t{1024}}) {
      const Bytes head = first(packetOfSize(size, order), kHeaderBytes);
      const Bytes behind = packetOfSize(1024);  // completes the false one in any case
      PacketReader reader;
      AllFound found;
      read(&reader, joined({head, allSamples(), behind}), SIZE_MAX, &found);
      ASSERT_EQ(found.size(), kSampleCount + 1U) << size;
      for (uint32_t i = 0; i < kSampleCount; ++i) {
        EXPECT_EQ(found[i].id, kSamples[i].id);
      }
      EXPECT_EQ(reader.skippedBytes(), kHeaderBytes);
      EXPECT_EQ(reader.badCrcs(), 1U);
    }
  }
}

TEST(ImcReader, APacketThatIsCutOffCostsOnlyItself) {
  const Bytes behind = joined({allSamples(), packetOfSize(1024)});
  for (uint32_t i = 0; i < kSampleCount; ++i) {
    for (const ByteOrder order : kBothOrders) {
      const Bytes packet = sampleBytes(i, order);
      for (size_t cut = 0; cut < packet.size(); ++cut) {
        ASSERT_EQ(packetsIn(joined({first(packet, cut), behind})), packetsIn(behind))
            << kSamples[i].name << " cut to " << cut;
      }
    }
  }
}

TEST(ImcReader, EachBitThatIsWrongCostsThePacketAndNoOther) {
  const Bytes behind = joined({sampleBytes(0), packetOfSize(1024), packetOfSize(0)});
  for (uint32_t i = 0; i < kSampleCount; ++i) {
    for (const ByteOrder order : kBothOrders) {
      const Bytes packet = sampleBytes(i, order);
      for (size_t bit = 0; bit < packet.size() * 8; ++bit) {
        Bytes damaged = packet;
        damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ 1U << bit % 8);
        ASSERT_EQ(packetsIn(joined({damaged, behind})), packetsIn(behind))
            << kSamples[i].name << " bit " << bit;
      }
    }
  }
}

TEST(ImcReader, CountsWhatItDidNotUse) {
  Bytes damaged = sampleBytes(5);
  damaged[40] ^= 1U;
  PacketReader reader;
  AllFound found;
  read(&reader, joined({{1, 2, 3}, sampleBytes(0), damaged, sampleBytes(1), {0x54}}), 7, &found);
  EXPECT_EQ(found.size(), 2U);
  EXPECT_EQ(reader.badCrcs(), 1U);
  EXPECT_EQ(reader.tooLong(), 0U);
  EXPECT_EQ(reader.skippedBytes(), 3 + damaged.size());
  EXPECT_EQ(reader.held(), 1U) << "it may be the first byte of a packet";
}

TEST(ImcReader, TheLongestPacketAndALongerOne) {
  for (const ByteOrder order : kBothOrders) {
    EXPECT_EQ(packetsIn(packetOfSize(kMostPayload, order)).size(), 1U);
    for (const size_t size : {size_t{kMostPayload} + 1, size_t{5000}, size_t{65535}}) {
      for (const size_t piece : {size_t{1}, size_t{500}, SIZE_MAX}) {
        PacketReader reader;
        AllFound found;
        const Bytes packet = packetOfSize(size, order);
        read(&reader, joined({sampleBytes(0), packet, sampleBytes(1)}), piece, &found);
        ASSERT_EQ(found.size(), 2U) << size;
        EXPECT_EQ(reader.tooLong(), 1U);
        EXPECT_EQ(reader.badCrcs(), 0U);
        EXPECT_EQ(reader.skippedBytes(), packet.size());
      }
    }
  }
}

/// A long packet's size is not trusted: garbage that looks like its header costs nothing.
TEST(ImcReader, TheHeaderOfALongPacketSwallowsNothing) {
  const Bytes head = first(packetOfSize(60000), kHeaderBytes);
  for (const size_t piece : {size_t{1}, SIZE_MAX}) {
    EXPECT_EQ(packetsIn(joined({head, allSamples()}), piece).size(), kSampleCount);
  }
}

TEST(ImcReader, TakesPacketsWithAnyTimeThatComputersHave) {
  for (const double time : {0.0, -1.0, 1.0, 300.0, 1795622130.0, std::nextafter(0x1p34, 0)}) {
    EXPECT_EQ(packetsIn(packetOf(150, {.time_s = time}, {}, ByteOrder::Little)).size(), 1U) << time;
  }
  for (const double time :
       {0.5, -2.0, 0x1p34, 1e300, -1e300, 1e-300, HUGE_VAL, -HUGE_VAL, static_cast<double>(NAN)}) {
    PacketReader reader;
    AllFound found;
    const Bytes packet = packetOf(150, {.time_s = time}, {}, ByteOrder::Big);
    read(&reader, packet, SIZE_MAX, &found);
    EXPECT_EQ(found.size(), 0U) << time;
    EXPECT_EQ(reader.badCrcs(), 0U);
    EXPECT_EQ(reader.skippedBytes() + reader.held(), packet.size());
  }
}

TEST(ImcReader, TakesNoMoreThanItHasRoomFor) {
  PacketReader reader;
  const Bytes all = joined({packetOfSize(1024), packetOfSize(1024), packetOfSize(1024)});
  const auto count = static_cast<uint32_t>(all.size());
  EXPECT_EQ(reader.push(all.data(), count), 2 * kMostPacket);
  EXPECT_EQ(reader.push(all.data(), count), 0U);
  Packet packet;
  EXPECT_TRUE(reader.next(&packet));
  EXPECT_TRUE(reader.next(&packet));
  EXPECT_FALSE(reader.next(&packet));
  EXPECT_EQ(reader.push(all.data() + 2 * kMostPacket, kMostPacket), kMostPacket);
  EXPECT_TRUE(reader.next(&packet));
  EXPECT_EQ(reader.push(nullptr, 0), 0U);
}

/// Headers that state the greatest payload, as close together as their times allow: the most work.
TEST(ImcReader, ManyFalseHeadersInEachOther) {
  Bytes bytes;
  for (int i = 0; i < 3000; ++i) {
    bytes = joined({bytes, {0x54, 0xFE, 0x00, 0x00, 0xFF, 0x03, 0x41}});
  }
  PacketReader reader;
  AllFound found;
  read(&reader, joined({bytes, sampleBytes(1), packetOfSize(1024)}), 1, &found);
  EXPECT_EQ(found.size(), 2U);
  EXPECT_EQ(reader.badCrcs(), 2999U) << "the last one has the time of another";
  EXPECT_EQ(reader.skippedBytes(), bytes.size());
}

TEST(ImcReader, ForgetsWhatHadArrivedOnAnOldConnection) {
  PacketReader reader;
  AllFound found;
  read(&reader, first(packetOfSize(1024), 500), SIZE_MAX, &found);
  EXPECT_EQ(reader.held(), 500U);
  reader.reset();
  EXPECT_EQ(reader.held(), 0U);
  EXPECT_EQ(reader.skippedBytes(), 500U);
  read(&reader, sampleBytes(1), SIZE_MAX, &found);
  EXPECT_EQ(found.size(), 1U);
}

TEST(ImcReader, FindsAllPacketsBetweenRandomBytes) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    Bytes garbage(random() % 200);
    for (uint8_t& byte : garbage) {
      byte = static_cast<uint8_t>(random());
    }
    const Bytes end = packetOfSize(1024);
    const AllFound found =
        packetsIn(joined({garbage, allSamples(), garbage, allSamples(), end}), 1 + random() % 99);
    ASSERT_EQ(found.size(), 2 * kSampleCount + 1U);
  }
}

}  // namespace
}  // namespace glider::hooks::imc
