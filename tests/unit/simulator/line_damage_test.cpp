// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/faults/line_damage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <string>

namespace glider::simulator {
namespace {

constexpr double kBaud = 115200;
constexpr int kBytes = 100000;

using Arrivals = std::deque<LineDamage::Arrival>;

Arrivals pass(const LineFault& fault, int count = kBytes, uint64_t seed = 1, uint8_t byte = 0x55) {
  LineDamage damage({fault}, fault.way, seed, kBaud);
  Arrivals out;
  for (int i = 0; i < count; ++i) {
    damage.pass(byte, 10, 10 + i * 10 / kBaud, out);
  }
  return out;
}

TEST(LineDamage, LosesItsShareOfBytes) {
  EXPECT_NEAR(static_cast<double>(pass({.loss = 0.1}).size()), 0.9 * kBytes, 0.01 * kBytes);
  EXPECT_TRUE(pass({.cut = true}).empty());
  EXPECT_EQ(pass({.when = {11, 12}, .cut = true}).size(), size_t{kBytes}) << "not yet";
}

TEST(LineDamage, TurnsOneBitOfItsShareOfBytes) {
  int turned = 0;
  for (const auto& arrival : pass({.flips = 0.1})) {
    const int bits = std::popcount(static_cast<unsigned>(arrival.value ^ 0x55));
    ASSERT_LE(bits, 1);
    turned += bits;
  }
  EXPECT_NEAR(turned, 0.1 * kBytes, 0.01 * kBytes);
}

TEST(LineDamage, BurstsAreAsLongAsTheyAreSaid) {
  const Arrivals arrivals = pass({.bursts = 1e-3, .burst_bytes = 50});
  int wrong = 0;
  for (const auto& arrival : arrivals) {
    wrong += arrival.value != 0x55;
  }
  // A burst begins at one of the bytes between bursts: 1000 of them on average, then 50.
  EXPECT_NEAR(wrong, kBytes * 50 / 1050.0 * 255 / 256, 0.01 * kBytes);
}

TEST(LineDamage, EarlierFramesComeAgainWhole) {
  LineFault fault{.when = {10, 11}, .replayed = 1};
  LineDamage damage({fault}, fault.way, 1, kBaud);
  Arrivals out;
  const auto send = [&](uint8_t byte, double now_s) {
    double more_s = damage.pass(byte, now_s, now_s, out);
    return more_s + damage.pass(0, now_s, now_s, out);
  };
  EXPECT_EQ(send(1, 9), 0) << "not yet";
  EXPECT_GT(send(2, 10.2), 0) << "the wire is busy longer";
  EXPECT_EQ(send(3, 12), 0) << "no more";
  std::string heard;
  for (const auto& arrival : out) {
    heard += static_cast<char>('0' + arrival.value);
  }
  EXPECT_EQ(heard, "10201030");
}

TEST(LineDamage, DelayedBytesKeepTheirOrder) {
  LineFault fault{.when = {10, 11}, .delay_s = 5};
  LineDamage damage({fault}, fault.way, 1, kBaud);
  Arrivals out;
  damage.pass(1, 10.5, 10.5, out);
  damage.pass(2, 11.5, 11.5, out);  // the line is well again
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[0].at_s, 15.5);
  EXPECT_EQ(out[1].at_s, 15.5);
}

TEST(LineDamage, DoublesWholeFramesAndTakesTheTimeForIt) {
  LineFault fault{.doubled = 1};
  LineDamage damage({fault}, fault.way, 1, kBaud);
  Arrivals out;
  EXPECT_EQ(damage.pass(7, 1, 1, out), 0);
  EXPECT_EQ(damage.pass(8, 1, 1, out), 0);
  EXPECT_NEAR(damage.pass(0, 1, 1, out), 30 / kBaud, 1e-12);
  std::string got;
  for (const auto& arrival : out) {
    got += std::to_string(arrival.value);
  }
  EXPECT_EQ(got, "780780");
}

TEST(LineDamage, AReceiverAtAnotherSpeedReceivesOtherBytesAndAnotherNumber) {
  EXPECT_EQ(pass({.heard_at_baud = 230400}).size(), size_t{2 * kBytes});
  EXPECT_EQ(pass({.heard_at_baud = 57600}).size(), size_t{kBytes / 2});
}

TEST(LineDamage, IsTheSeedsAlone) {
  const auto same = [](const Arrivals& a, const Arrivals& b) {
    return std::ranges::equal(a, b, {}, &LineDamage::Arrival::value, &LineDamage::Arrival::value);
  };
  EXPECT_TRUE(same(pass({.flips = 0.3}), pass({.flips = 0.3})));
  EXPECT_FALSE(same(pass({.flips = 0.3}), pass({.flips = 0.3}, kBytes, 2)));
}

TEST(LineDamage, OfAnotherDirectionIsNotItsOwn) {
  EXPECT_TRUE(
      LineDamage({{.way = LineWay::ToFlight, .cut = true}}, LineWay::ToSbc, 1, kBaud).none());
}

}  // namespace
}  // namespace glider::simulator
