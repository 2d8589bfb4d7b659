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
  SensorList list;
  Hello hello;
  Subscribe subscribe;
  TransitionNotice notice;
  MissionNote note;
  Done done;
  const int takers = decode(frame, beacon) + decode(frame, welcome) + decode(frame, head, list) +
                     decode(frame, hello) + decode(frame, subscribe) + decode(frame, notice) +
                     decode(frame, done) + decode(frame, note) + decodeList(frame, list);
  EXPECT_LE(takers, 1);
  return takers == 1;
}

TEST(Messages, EachIsTakenByItsOwnDecoderOnlyAndOnlyAtItsLength) {
  for (const auto& [name, frame] : exampleFrames()) {
    EXPECT_TRUE(taken(frame)) << name;
    for (uint32_t size = 0; size <= kMostPayload; ++size) {
      Frame other = frame;
      other.size = static_cast<uint8_t>(size);
      EXPECT_EQ(taken(other), size == frame.size) << name << " with " << size << " bytes";
    }
  }
}

TEST(Messages, TickComesBack) {
  TickHead head;
  SensorList readings;
  ASSERT_TRUE(decode(exampleFrames()[2].second, head, readings));
  EXPECT_FALSE(head.more);
  EXPECT_FALSE(head.continues);
  EXPECT_TRUE(head.virtual_time);
  EXPECT_EQ(head.link, 7U);
  EXPECT_EQ(head.vehicle_time_s, 264);
  EXPECT_EQ(head.cycle, 66U);
  EXPECT_EQ(head.hook_state, HookState::Active);
  EXPECT_EQ(head.answer, HookAnswer::Accepted);
  EXPECT_EQ(head.answered_sequence, 258);
  EXPECT_EQ(head.session, 7U);
  ASSERT_EQ(readings.count, 2U);
  EXPECT_EQ(readings.values[0].id, GLIDER_M_DEPTH);
  EXPECT_EQ(readings.values[0].value, 12.5);
  EXPECT_EQ(readings.values[1].value, 3910.5);
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

TEST(Messages, ValuesThatNoSenderWritesAreRefused) {
  Frame frame;
  encode(Beacon{}, frame);
  Beacon beacon;
  frame.payload[6] = 6;  // no such hook state
  EXPECT_FALSE(decode(frame, beacon));
  frame.payload[6] = 0;
  frame.payload[1] = 1;  // a flag of no meaning
  EXPECT_FALSE(decode(frame, beacon));

  Done done;
  encode(Done{1, 0, {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0}}, frame);
  EXPECT_FALSE(decode(frame, done));
  encode(Done{1, 0, {1, 0, 0, 3}}, frame);
  EXPECT_FALSE(decode(frame, done));
  encode(Done{1, kMostSession + 1, {1, 0, 0, 1}}, frame);
  EXPECT_FALSE(decode(frame, done));

  Subscribe subscribe;
  encode(Subscribe{1, {GLIDER_SENSOR_COUNT}}, frame);
  EXPECT_FALSE(decode(frame, subscribe));

  encodeEmptyList(MessageType::Write, frame);
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
    encodeEmptyList(MessageType::Sensors, frame);
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

TEST(Messages, AFullListSaysSoAndStaysWhole) {
  Frame frame;
  encodeEmptyList(MessageType::Sensors, frame);
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
  EXPECT_EQ(nextSession(1), 2U);
  EXPECT_EQ(nextSession(kMostSession), 1U);
  EXPECT_TRUE(isNewerSession(1, 0));
  EXPECT_TRUE(isNewerSession(kMostSession, 0));
  EXPECT_FALSE(isNewerSession(0, 0));
  EXPECT_TRUE(isNewerSession(6, 5));
  EXPECT_FALSE(isNewerSession(5, 5));
  EXPECT_FALSE(isNewerSession(4, 5));
  EXPECT_TRUE(isNewerSession(1, kMostSession));
  EXPECT_FALSE(isNewerSession(kMostSession, 1));
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
  encode(TickHead{}, first);
  first.sequence = 9;
  markMore(first);
  auto bytes = bytesOf(first);
  lockstep.toSbc(bytes.data(), static_cast<uint32_t>(bytes.size()));
  EXPECT_TRUE(lockstep.settled()) << "only the last part of a tick is answered";
  Frame last;
  encode(TickHead{}, last);
  last.sequence = 10;
  bytes = bytesOf(last);
  lockstep.toSbc(bytes.data(), static_cast<uint32_t>(bytes.size()) - 1);
  EXPECT_TRUE(lockstep.settled()) << "not whole yet";
  lockstep.toSbc(&bytes.back(), 1);
  EXPECT_FALSE(lockstep.settled());
  Frame done;
  encode(Done{9, 0, {}}, done);
  bytes = bytesOf(done);
  lockstep.fromSbc(bytes.data(), static_cast<uint32_t>(bytes.size()));
  EXPECT_FALSE(lockstep.settled());
  encode(Done{10, 0, {}}, done);
  bytes = bytesOf(done);
  lockstep.fromSbc(bytes.data(), static_cast<uint32_t>(bytes.size()));
  EXPECT_TRUE(lockstep.settled());
}

}  // namespace
}  // namespace glider::hooks
