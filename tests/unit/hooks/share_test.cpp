// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Messages of shares: packing, refusal, and their size.

#include "tests/fuzz/share_hostile.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>

namespace glider::hooks::share {
namespace {

using share_hostile::Bytes;
using share_hostile::messageOf;
using share_hostile::Scales;
using share_hostile::Values;
using share_hostile::valuesIn;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Scale kDepth{0, 1, 201};
const Scale kTemperature{0, 0.05, 601};

MessageSize sizeOf(const Scales& scales) {
  return share::sizeOf(scales.data(), static_cast<uint32_t>(scales.size()));
}

bool isSame(double one, double other) {
  return std::isnan(one) ? std::isnan(other)
                         : std::bit_cast<uint64_t>(one) == std::bit_cast<uint64_t>(other);
}

TEST(Share, IsToldAsTheNearestValue) {
  for (const auto& [value, digit] : {std::pair{0.0, 1U},
                                     {0.49, 1U},
                                     {0.5, 2U},
                                     {1.0, 2U},
                                     {1.4999, 2U},
                                     {199.5, 201U},
                                     {200.0, 201U},
                                     {200.49, 201U},
                                     {-0.49, 1U},
                                     {-0.0, 1U},
                                     {0.49999999999999994, 1U}}) {
    EXPECT_EQ(digitOf(kDepth, value), digit) << value;
  }
  EXPECT_EQ(digitOf({0, 1, 1}, 0.4), 1U);
  EXPECT_EQ(digitOf({-3, 2, UINT32_MAX - 1}, -3 + 2.0 * (UINT32_MAX - 2)), UINT32_MAX - 1);
}

TEST(Share, OutsideOfItsScaleItIsUnknown) {
  for (const double value :
       {-0.5, -1.0, 200.5, 201.0, 1e300, -1e300, kInfinity, -kInfinity, kNan}) {
    EXPECT_EQ(digitOf(kDepth, value), 0U) << value;
  }
  EXPECT_EQ(digitOf({-1e308, 1e-10, 5}, 1e308), 0U);
  EXPECT_TRUE(std::isnan(valueOf(kDepth, 0)));
  EXPECT_EQ(valueOf(kDepth, 201), 200.0);
}

TEST(Share, AMessageIsOneNumber) {
  const Scales scales{{10, 1, 9}, {0, 1, 99}};  // bases 10 and 100
  EXPECT_EQ(sizeOf(scales).bytes, 3U);          // 255 + 256 (9 + 10 99) = 255999
  EXPECT_EQ(sizeOf(scales).bits, 18U);
  // 7 + 256 (3 + 10 42) = 108295
  EXPECT_EQ(messageOf(scales, {12, 41}, 7), (Bytes{0x07, 0xA7, 0x01}));
  EXPECT_EQ(messageOf(scales, {kNan, 500}, 7), (Bytes{0x07, 0, 0}));
  EXPECT_EQ(valuesIn(scales, {0x07, 0xA7, 0x01}, 7), (Values{12, 41}));
}

TEST(Share, TheSignatureAloneIsAMessage) {
  EXPECT_EQ(sizeOf(Scales{}).bytes, 1U);
  EXPECT_EQ(messageOf({}, {}, 0), Bytes{0});
  EXPECT_TRUE(valuesIn({}, {9}, 9));
  EXPECT_FALSE(valuesIn({}, {9}, 8));
}

TEST(Share, AMessageFillsAFrameAndNotMore) {
  Scales scales(7, Scale{0, 1, UINT32_MAX - 1});
  scales.push_back({0, 1, (1U << 24) - 1});  // 8 + 7 31.99.. + 24 bits
  EXPECT_EQ(sizeOf(scales).bytes, 32U);
  EXPECT_EQ(sizeOf(scales).bits, 256U);
  const Values greatest{4294967293.0, 4294967293.0, 4294967293.0, 4294967293.0,
                        4294967293.0, 4294967293.0, 4294967293.0, 16777214.0};
  EXPECT_EQ(valuesIn(scales, messageOf(scales, greatest, 255), 255), greatest);
  scales.push_back({0, 1, 1});
  EXPECT_EQ(sizeOf(scales).bytes, 0U);
  EXPECT_EQ(sizeOf(scales).bits, 0U);
  MessageWriter writer;
  for (const Scale& scale : scales) {
    writer.put(scale, scale.values - 1.0);
  }
  uint8_t bytes[Number::kMostBytes];
  EXPECT_FALSE(writer.end(0, bytes, sizeof bytes));
}

/// 8 signatures and 1024 values, unknown counted, are 13 bits.
TEST(Share, AMiniPacketHoldsThirteenBits) {
  const Scale most{0, 1, 1023}, more{0, 1, 1024};
  EXPECT_EQ(share::sizeOf(&most, 1).mini_bits, 13U);
  EXPECT_EQ(share::sizeOf(&more, 1).mini_bits, 0U);
  EXPECT_EQ(share::sizeOf(&more, 1).bytes, 3U);
  const Scales two{{0, 1, 31}, {0, 1, 31}};
  EXPECT_EQ(sizeOf(two).mini_bits, 13U);
  const Scales three{{0, 1, 31}, {0, 1, 31}, {0, 1, 1}};
  EXPECT_EQ(sizeOf(three).mini_bits, 0U);
  uint32_t bits = 0;
  EXPECT_TRUE(MessageWriter().put(most, 1022).endMini(7, bits));
  EXPECT_EQ(bits, 0x1FFFU);
  EXPECT_FALSE(MessageWriter().put(more, 1023).endMini(7, bits));
}

/// All pairs of values, each signature: read as written, and only with the signature's low bits.
TEST(Share, AMiniPacketIsReadAsItWasWritten) {
  const Scale depth{0, 2, 19}, level{-2, 0.5, 30};
  std::set<uint32_t> all;
  for (uint32_t i = 0; i <= depth.values; ++i) {
    for (uint32_t j = 0; j <= level.values; ++j) {
      for (uint8_t signature = 0xA0; signature < 0xA8; ++signature) {
        const double one = valueOf(depth, i), other = valueOf(level, j);
        uint32_t bits = 0;
        ASSERT_TRUE(MessageWriter().put(level, other).put(depth, one).endMini(signature, bits));
        EXPECT_TRUE(all.insert(bits).second);
        MessageReader reader(bits);
        EXPECT_TRUE(isSame(reader.take(depth), one));
        EXPECT_TRUE(isSame(reader.take(level), other));
        EXPECT_TRUE(reader.endMini(signature));
        EXPECT_TRUE(reader.endMini(static_cast<uint8_t>(signature - 0x80)));
        EXPECT_FALSE(reader.endMini(static_cast<uint8_t>(signature ^ 1U)));
        EXPECT_FALSE(reader.end(signature, 2));
      }
    }
  }
  EXPECT_EQ(*all.rbegin(), all.size() - 1) << "no number is wasted";
  MessageReader beyond(static_cast<uint32_t>(all.size()));
  (void)beyond.take(depth);
  (void)beyond.take(level);
  EXPECT_FALSE(beyond.endMini(0));
  const uint8_t frame[] = {5};
  EXPECT_TRUE(MessageReader(frame, 1).end(5, 1));
  EXPECT_FALSE(MessageReader(frame, 1).endMini(5)) << "it is a frame";
}

TEST(Share, IsNotWrittenIntoLessRoom) {
  uint8_t bytes[4] = {0, 0, 0, 0xEE};
  MessageWriter writer;
  writer.put({0, 1, 60000}, 59999);
  EXPECT_FALSE(writer.end(1, bytes, 2));
  EXPECT_EQ(bytes[2], 0);
  EXPECT_FALSE(MessageWriter().end(1, bytes, 33));
}

TEST(Share, IsRefusedAsAWhole) {
  const Scales scales{kDepth, kTemperature};
  const Bytes good = messageOf(scales, {17, 12.25}, 0x5A);
  ASSERT_EQ(good.size(), 4U);
  ASSERT_TRUE(valuesIn(scales, good, 0x5A));
  EXPECT_FALSE(valuesIn(scales, good, 0x5B));
  EXPECT_FALSE(valuesIn(scales, {good.begin(), good.end() - 1}, 0x5A));
  EXPECT_FALSE(valuesIn(scales, {}, 0));
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_FALSE(valuesIn(scales, longer, 0x5A));
  EXPECT_FALSE(valuesIn(scales, Bytes(40, 0x5A), 0x5A));
  // The greatest is 0x5A + 256 (202 602 - 1).
  EXPECT_TRUE(valuesIn(scales, {0x5A, 0x03, 0xDB, 0x01}, 0x5A));
  EXPECT_FALSE(valuesIn(scales, {0x5A, 0x04, 0xDB, 0x01}, 0x5A));
  EXPECT_FALSE(valuesIn(scales, {0x5A, 0xFF, 0xFF, 0xFF}, 0x5A));
}

/// Sets of shares that fit into a frame, with any numbers.
class RandomSets {
 public:
  Scales scales() {
    Scales found;
    const auto count = static_cast<uint32_t>(rng_() % 12);
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t values = static_cast<uint32_t>(rng_()) >> (rng_() % 32);
      const double step = std::ldexp(1 + real() / 2, static_cast<int>(rng_() % 20) - 12);
      found.push_back(
          {step * std::floor(real() * 1e6), step, std::clamp(values, 1U, UINT32_MAX - 1)});
      if (sizeOf(found).bytes == 0) {
        found.pop_back();
      }
    }
    return found;
  }
  /// One of the scale, or none; and as it is sent, from less than half a step away.
  std::pair<double, double> value(const Scale& scale) {
    if (rng_() % 8 == 0) {
      return {kNan, rng_() % 2 == 0 ? kNan : scale.lowest - scale.step};
    }
    const auto digit = static_cast<uint32_t>(1 + rng_() % scale.values);
    const double told = valueOf(scale, digit);
    return {told, told + real() * 0.4 * scale.step};
  }
  uint8_t byte() { return static_cast<uint8_t>(rng_()); }

 private:
  /// -1 to 1.
  double real() { return static_cast<double>(static_cast<int32_t>(rng_())) / 2147483648.0; }
  std::mt19937 rng_{20261128};
};

uint32_t setsToTry() {
  const char* wanted = std::getenv("GLIDER_SHARE_SETS");
  return wanted != nullptr ? static_cast<uint32_t>(std::strtoul(wanted, nullptr, 10)) : 20000;
}

TEST(ShareHostile, RandomSetsAreHeardAsTheyAreTold) {
  RandomSets random;
  for (uint32_t round = 0; round < setsToTry(); ++round) {
    const Scales scales = random.scales();
    Values told, given;
    for (const Scale& scale : scales) {
      const auto [value, near] = random.value(scale);
      told.push_back(value);
      given.push_back(near);
    }
    const uint8_t signature = random.byte();
    const Bytes bytes = messageOf(scales, given, signature);
    ASSERT_FALSE(bytes.empty());
    const auto received = valuesIn(scales, bytes, signature);
    ASSERT_TRUE(received);
    for (size_t i = 0; i < told.size(); ++i) {
      ASSERT_TRUE(isSame((*received)[i], told[i])) << round << ' ' << i << ' ' << told[i];
    }
    ASSERT_FALSE(valuesIn(scales, bytes, static_cast<uint8_t>(signature + 1)));
    ASSERT_FALSE(valuesIn(scales, {bytes.begin(), bytes.end() - 1}, signature));
  }
}

TEST(ShareHostile, AMessageIsTheOnlyTextOfItsValues) {
  std::mt19937 rng(7);
  for (uint32_t round = 0; round < setsToTry(); ++round) {
    Bytes input(rng() % 40);
    for (uint8_t& byte : input) {
      byte = static_cast<uint8_t>(rng());
    }
    share_hostile::requireOneText(input);
  }
}

/// The bits of an optional number of DCCL: ceil(log2(n + 1)) of n values and none.
uint32_t bitsInDccl(const Scale& scale) {
  return static_cast<uint32_t>(std::bit_width(scale.values));
}

/// Of a message with an id below 128: its head and its body are padded to whole bytes each.
uint32_t bytesInDccl(const Scales& scales) {
  uint32_t bits = 0;
  for (const Scale& scale : scales) {
    bits += bitsInDccl(scale);
  }
  return 1 + (bits + 7) / 8;
}

TEST(Share, IsNeverLargerThanInDccl) {
  const Scale kBox{38, 1e-4, 20001}, kTime{0, 1, 86400}, kTruth{0, 1, 2}, kArc{0, 1, 255};
  for (const auto& [scales, most] : {std::pair<Scales, uint32_t>{{kDepth}, 2},
                                     {{kDepth, kTemperature}, 4},
                                     {{kTime, kBox, kBox, kDepth, kTemperature}, 9},
                                     {{kTruth, kTruth, kTruth, kTruth, kTruth}, 2},
                                     {{kArc, kTruth}, 3}}) {
    EXPECT_EQ(sizeOf(scales).bytes, most);
    EXPECT_LE(sizeOf(scales).bytes, bytesInDccl(scales));
  }
  // The example of its documentation: 8 bits of id and 65 of values, which it needs even as
  // required ones.
  EXPECT_EQ(bytesInDccl({kTime, kBox, kBox, kDepth, kTemperature}), 10U);
  EXPECT_EQ(sizeOf({kTime, kBox, kBox, kDepth, kTemperature}).bits, 70U);
}

}  // namespace
}  // namespace glider::hooks::share
