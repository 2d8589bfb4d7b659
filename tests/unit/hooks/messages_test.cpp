// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/messages.h"

#include "hooks/protocol/lockstep.h"
#include "tests/unit/hooks/examples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glider::hooks {
namespace {

/// Whether any decoder takes `frame`.
bool taken(const Frame& frame) {
  Beacon beacon;
  Welcome welcome;
  TickHead head;
  TickReadings readings;
  SensorList list;
  Hello hello;
  Subscribe subscribe;
  TransitionNotice notice;
  MissionNote note;
  Done done;
  Nap nap;
  const bool tick = decode(frame, head) && decode(frame, exampleSubscription(), readings);
  const int takers = decode(frame, beacon) + decode(frame, welcome) + tick + decode(frame, hello) +
                     decode(frame, subscribe) + decode(frame, notice) + decode(frame, done) +
                     decode(frame, note) + decodeList(frame, list) +
                     decode(frame, exampleSubscription(), nap);
  EXPECT_LE(takers, 1);
  return takers == 1;
}

TEST(Messages, EachIsTakenByItsOwnDecoderOnlyAndOnlyAtItsLength) {
  for (const auto& [name, frame] : exampleFrames()) {
    EXPECT_TRUE(taken(frame)) << name;
    for (uint32_t size = 0; size <= kMostPayload; ++size) {
      Frame other = frame;
      other.size = static_cast<uint16_t>(size);
      EXPECT_EQ(taken(other), size == frame.size) << name << " with " << size << " bytes";
    }
  }
}

TEST(Messages, TickComesBack) {
  TickHead head;
  TickReadings readings;
  const Frame frame = exampleFrames()[2].second;
  ASSERT_TRUE(decode(frame, head));
  ASSERT_TRUE(decode(frame, exampleSubscription(), readings));
  EXPECT_TRUE(head.virtual_time);
  EXPECT_EQ(head.link, 7U);
  EXPECT_EQ(head.vehicle_time_s, 264);
  EXPECT_EQ(head.cycle, 66U);
  EXPECT_EQ(head.hook_state, HookState::Active);
  EXPECT_EQ(head.answer, HookAnswer::Accepted);
  EXPECT_EQ(head.answered_sequence, 258);
  EXPECT_EQ(head.session, 7U);
  EXPECT_EQ(readings.told[0], ReadingReport::Value);
  EXPECT_EQ(readings.values[0], 12.5);
  EXPECT_EQ(readings.told[1], ReadingReport::Unchanged);
  EXPECT_EQ(readings.told[2], ReadingReport::Nothing);
}

TEST(Messages, TheLargestTickFitsAFrameAndComesBack) {
  Subscribe subscription;
  TickReadings readings;
  for (uint32_t i = 0; i < kMostSubscriptions; ++i) {
    subscription.sensors[subscription.count++] = {GLIDER_M_LAT, 1, 0};
    readings.told[i] = ReadingReport::Value;
    readings.values[i] = 3910 + i / 64.0;
  }
  Frame frame;
  encode(TickHead{}, subscription, readings, frame);
  EXPECT_EQ(frame.size, 24U + 2 * 8 + 64 * 8);
  TickReadings again;
  ASSERT_TRUE(decode(frame, subscription, again));
  for (uint32_t i = 0; i < kMostSubscriptions; ++i) {
    EXPECT_EQ(again.told[i], ReadingReport::Value);
    EXPECT_EQ(again.values[i], readings.values[i]);
  }
  encode(subscription, frame);
  Subscribe back;
  ASSERT_TRUE(decode(frame, back));
  EXPECT_EQ(back.count, kMostSubscriptions);
}

TEST(Messages, ATicksMapsMustMakeSense) {
  const Subscribe subscription = exampleSubscription();
  Frame frame;
  encode(TickHead{}, subscription, TickReadings{}, frame);
  TickReadings readings;
  ASSERT_TRUE(decode(frame, subscription, readings));
  frame.payload[24] = 8;  // a fourth sensor of three
  EXPECT_FALSE(decode(frame, subscription, readings));
  frame.payload[24] = 0;
  frame.payload[25] = 1;  // a value of what was not reported
  EXPECT_FALSE(decode(frame, subscription, readings));
  frame.payload[24] = 1;  // the value is missing
  EXPECT_FALSE(decode(frame, subscription, readings));
  frame.size += 4;
  EXPECT_TRUE(decode(frame, subscription, readings));
  frame.size += 1;
  EXPECT_FALSE(decode(frame, subscription, readings));
}

TEST(Messages, ASubscriptionsCheckKnowsRatesAndDeadBands) {
  const Subscribe one = exampleSubscription();
  Subscribe other = one;
  EXPECT_EQ(subscriptionCheck(one), subscriptionCheck(other));
  other.sensors[2].every = 14;
  EXPECT_NE(subscriptionCheck(one), subscriptionCheck(other));
  other = one;
  other.sensors[0].dead_band = 0.5F;
  EXPECT_NE(subscriptionCheck(one), subscriptionCheck(other));
  EXPECT_EQ(subscriptionCheck(Subscribe{}), 0xFFFF);
}

TEST(Messages, AnotherVersionsHelloAndBeaconAreStillReadAsSuch) {
  Frame frame;
  frame.type = MessageType::Beacon;
  frame.size = 3;
  frame.payload[0] = kProtocolVersion + 1;
  Beacon beacon;
  ASSERT_TRUE(decode(frame, beacon));
  EXPECT_EQ(beacon.version, kProtocolVersion + 1);
  frame.type = MessageType::Hello;
  Hello hello;
  ASSERT_TRUE(decode(frame, hello));
  EXPECT_EQ(hello.version, kProtocolVersion + 1);
}

TEST(Messages, TheBeaconOfVersion2IsUnderstoodAsThat) {
  const uint8_t bytes[] = {0x0c, 1, 1, 2, 4, 0x78, 0x56, 0x34, 0x12, 2, 0xff, 0xc3, 0};
  FrameDecoder decoder;
  bool whole = false;
  for (const uint8_t byte : bytes) {
    whole = decoder.push(byte);
  }
  ASSERT_TRUE(whole);
  Beacon beacon;
  ASSERT_TRUE(decode(decoder.frame(), beacon));
  EXPECT_EQ(beacon.version, 2);
}

TEST(Messages, ValuesThatNoSenderWritesAreRefused) {
  Frame frame;
  encode(Beacon{}, frame);
  Beacon beacon;
  frame.payload[9] = 6;  // no such hook state
  EXPECT_FALSE(decode(frame, beacon));
  frame.payload[9] = 0;
  EXPECT_TRUE(decode(frame, beacon));
  frame.payload[1] = 128;  // a feature of later versions
  EXPECT_TRUE(decode(frame, beacon));
  EXPECT_EQ(beacon.features.offers, 128);
  encode(Welcome{false, 1, 0}, frame);
  Welcome welcome;
  frame.payload[0] = 1;  // a flag of no meaning
  EXPECT_FALSE(decode(frame, welcome));

  Done done;
  encode(Done{1, 0, {std::numeric_limits<double>::quiet_NaN()}}, frame);
  EXPECT_FALSE(decode(frame, done));
  encode(Done{1, 0, {1, 0, 0, static_cast<MissionPhase>(3)}}, frame);
  EXPECT_FALSE(decode(frame, done));

  Subscribe subscribe;
  for (const Subscription& wrong :
       {Subscription{GLIDER_SENSOR_COUNT, 1, 0}, Subscription{0, 0, 0}, Subscription{0, 1, -0.5F},
        Subscription{0, 1, std::numeric_limits<float>::quiet_NaN()},
        Subscription{0, 1, std::numeric_limits<float>::infinity()}}) {
    encode(Subscribe{1, {wrong}}, frame);
    EXPECT_FALSE(decode(frame, subscribe));
  }

  encodeEmptyList(frame);
  EXPECT_FALSE(appendValue(frame, {GLIDER_SENSOR_COUNT, 1}));
  EXPECT_EQ(frame.size, 1);
}

TEST(Messages, WidthsKeepWhatTheSensorArrayKeeps) {
  struct Row {
    uint16_t id;
    double in, out;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Row rows[] = {
      {GLIDER_M_DEPTH, 0.1, static_cast<double>(0.1F)},
      {GLIDER_M_DEPTH, nan, nan},
      {GLIDER_M_DEPTH, -infinity, -infinity},
      {GLIDER_M_LAT, 3910.123456789, 3910.123456789},
      {GLIDER_X_HOOK_STATE, 3, 3},
      {GLIDER_X_HOOK_STATE, -5, -5},
      {GLIDER_X_HOOK_STATE, 1e9, 127},
      {GLIDER_X_HOOK_STATE, -1e9, -127},
      {GLIDER_X_HOOK_STATE, nan, nan},
  };
  for (const Row& row : rows) {
    Frame frame;
    encodeEmptyList(frame);
    ASSERT_TRUE(appendValue(frame, {row.id, row.in}));
    SensorList list;
    ASSERT_TRUE(decodeList(frame, list));
    ASSERT_EQ(list.count, 1U);
    if (std::isnan(row.out)) {
      EXPECT_TRUE(std::isnan(list.values[0].value));
    } else {
      EXPECT_EQ(list.values[0].value, row.out);
    }
  }
}

TEST(Messages, AFullListReportsItAndStaysWhole) {
  Frame frame;
  encodeEmptyList(frame);
  uint32_t count = 0;
  while (appendValue(frame, {GLIDER_X_HOOK_STATE, 1})) {
    ++count;
  }
  EXPECT_EQ(count, 83U);
  SensorList list;
  ASSERT_TRUE(decodeList(frame, list));
  EXPECT_EQ(list.count, count);
}

TEST(Messages, SessionsCountRound) {
  EXPECT_EQ(hookNextSession(1), 2U);
  EXPECT_EQ(hookNextSession(kMostSession), 1U);
  EXPECT_TRUE(hookIsNewerSession(1, 0));
  EXPECT_TRUE(hookIsNewerSession(kMostSession, 0));
  EXPECT_FALSE(hookIsNewerSession(0, 0));
  EXPECT_TRUE(hookIsNewerSession(6, 5));
  EXPECT_FALSE(hookIsNewerSession(5, 5));
  EXPECT_FALSE(hookIsNewerSession(4, 5));
  EXPECT_TRUE(hookIsNewerSession(1, kMostSession));
  EXPECT_FALSE(hookIsNewerSession(kMostSession, 1));
}

TEST(Messages, LockstepWaitsForTheDoneOfTheNewestFrame) {
  Lockstep lockstep;
  auto bytesOf = [](const Frame& frame) {
    std::vector<uint8_t> bytes(kMostEncodedBytes);
    bytes.resize(encodeFrame(frame, bytes.data()));
    return bytes;
  };
  EXPECT_TRUE(lockstep.settled());
  Frame first;
  encode(Welcome{}, first);
  first.sequence = 9;
  auto bytes = bytesOf(first);
  lockstep.toSbc(bytes.data(), static_cast<uint32_t>(bytes.size()));
  EXPECT_FALSE(lockstep.settled());
  Frame last;
  encode(TickHead{}, Subscribe{}, TickReadings{}, last);
  last.sequence = 10;
  bytes = bytesOf(last);
  lockstep.toSbc(bytes.data(), static_cast<uint32_t>(bytes.size()) - 1);
  Frame done;
  encode(Done{9, 0, {}}, done);
  bytes = bytesOf(done);
  lockstep.fromSbc(bytes.data(), static_cast<uint32_t>(bytes.size()));
  EXPECT_TRUE(lockstep.settled()) << "the tick is not whole yet";
  bytes = bytesOf(last);
  lockstep.toSbc(&bytes.back(), 1);
  EXPECT_FALSE(lockstep.settled());
  encode(Done{10, 0, {}}, done);
  bytes = bytesOf(done);
  lockstep.fromSbc(bytes.data(), static_cast<uint32_t>(bytes.size()));
  EXPECT_TRUE(lockstep.settled());
}

}  // namespace
}  // namespace glider::hooks
