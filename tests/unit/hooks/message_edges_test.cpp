// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Messages at the very edge of their limits: the last value that a sender writes, the first that
// none does.

#include "hooks/protocol/lockstep.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/tick.h"
#include "tests/unit/hooks/examples.h"
#include "tests/unit/hooks/line_ends.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

namespace glider::hooks {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(LockstepEdges, HalfAFrameOwesNothingNorDoesOneThatIsNotAnswered) {
  const auto bytesOf = [](const auto& message, uint8_t sequence) {
    Frame frame;
    encode(message, frame);
    frame.sequence = sequence;
    std::vector<uint8_t> bytes(kMostEncodedBytes);
    bytes.resize(encodeFrame(frame, bytes.data()));
    return bytes;
  };
  const auto size = [](const std::vector<uint8_t>& bytes) {
    return static_cast<uint32_t>(bytes.size());
  };
  Lockstep lockstep;
  auto welcome = bytesOf(Welcome{}, 9);
  lockstep.toSbc(welcome.data(), size(welcome));
  EXPECT_FALSE(lockstep.settled());
  const auto wrong = bytesOf(Done{8, 0, {}}, 1);
  lockstep.fromSbc(wrong.data(), size(wrong));
  EXPECT_FALSE(lockstep.settled()) << "that of an earlier frame";
  const auto done = bytesOf(Done{9, 0, {}}, 2);
  lockstep.fromSbc(done.data(), size(done));
  EXPECT_TRUE(lockstep.settled());
  welcome = bytesOf(Welcome{}, 10);
  lockstep.toSbc(welcome.data(), size(welcome) - 1);
  EXPECT_TRUE(lockstep.settled());
  lockstep.toSbc(&welcome.back(), 1);
  EXPECT_FALSE(lockstep.settled());
  const auto settled = bytesOf(Done{10, 0, {}}, 3);
  lockstep.fromSbc(settled.data(), size(settled));
  const auto note = bytesOf(MissionNote{}, 11);
  lockstep.toSbc(note.data(), size(note));
  EXPECT_TRUE(lockstep.settled()) << "a Note is not answered";
}

TEST(TickEdges, ReadingsOfAnotherFrameAreNotRead) {
  const Subscribe subscription = exampleSubscription();
  Frame frame;
  encode(TickHead{}, subscription, TickReadings{}, frame);
  TickReadings readings;
  ASSERT_TRUE(decode(frame, subscription, readings));
  frame.type = MessageType::Beacon;
  EXPECT_FALSE(decode(frame, subscription, readings));
}

/// What lies behind those that are subscribed is not part of a Tick.
TEST(TickEdges, OnlyWhatIsSubscribedIsReported) {
  const Subscribe subscription = exampleSubscription();
  TickReadings more;
  for (uint32_t i = subscription.count; i < kMostSubscriptions; ++i) {
    more.told[i] = HookReadingReport::Value;
  }
  Frame frame, same;
  encode(TickHead{}, subscription, TickReadings{}, frame);
  encode(TickHead{}, subscription, more, same);
  ASSERT_EQ(frame.size, same.size);
  EXPECT_EQ(std::memcmp(frame.payload, same.payload, frame.size), 0);
}

TEST(MessageEdges, ATextLongerThanItsMostIsRefused) {
  for (const uint32_t over : {0U, 1U}) {
    Frame frame;
    encode(MissionNote{}, frame);
    frame.payload[9] = static_cast<uint8_t>(kMostNoteBytes + over);
    std::memset(frame.payload + 10, 'x', kMostNoteBytes + over);
    frame.size = static_cast<uint16_t>(10 + kMostNoteBytes + over);
    MissionNote note;
    EXPECT_EQ(decode(frame, note), over == 0) << over;
  }
}

TEST(SensorWidths, EndWithTheList) {
  EXPECT_NE(sensorWidth(GLIDER_SENSOR_COUNT - 1), 0U);
  EXPECT_EQ(sensorWidth(GLIDER_SENSOR_COUNT), 0U);
  EXPECT_EQ(sensorWidth(0xFFFF), 0U);
}

/// Of a Tick without readings.
uint16_t headBytes() {
  Frame frame;
  encode(TickHead{}, Subscribe{}, TickReadings{}, frame);
  return frame.size;
}

TEST(TickEdges, OneFieldThatNoSenderWritesRefusesItWhole) {
  const TickHead fine{};
  const auto taken = [](TickHead head, auto&& spoil) {
    Frame frame;
    encode(head, Subscribe{}, TickReadings{}, frame);
    spoil(frame);
    TickHead back;
    return decode(frame, back);
  };
  const auto nothing = [](Frame&) {};
  EXPECT_TRUE(taken(fine, nothing));
  for (const double time : {kNaN, kInfinity, -kInfinity}) {
    TickHead head;
    head.vehicle_time_s = time;
    EXPECT_FALSE(taken(head, nothing)) << time;
  }
  TickHead head;
  head.hook_state = static_cast<HookState>(6);
  EXPECT_FALSE(taken(head, nothing));
  head.hook_state = static_cast<HookState>(5);
  EXPECT_TRUE(taken(head, nothing));
  head.answer = static_cast<HookAnswer>(120);
  EXPECT_FALSE(taken(head, nothing));
  head.answer = static_cast<HookAnswer>(8);
  EXPECT_TRUE(taken(head, nothing));
  for (int bit = 0; bit < 8; ++bit) {
    EXPECT_EQ(taken(fine, [&](Frame& f) { f.payload[0] = static_cast<uint8_t>(1U << bit); }),
              bit == 2 || bit == 3)
        << bit;
  }
  EXPECT_FALSE(taken(fine, [](Frame& f) { f.type = MessageType::Welcome; }));
  EXPECT_FALSE(taken(fine, [](Frame& f) { f.size = static_cast<uint16_t>(headBytes() - 1); }));
  EXPECT_TRUE(taken(fine, [](Frame& f) { f.size = headBytes(); }));
}

TEST(TickEdges, SubscriptionsUpToTheMost) {
  Subscribe most;
  for (uint32_t i = 0; i < kMostSubscriptions; ++i) {
    most.sensors[most.count++] = {GLIDER_M_DEPTH, 255, 0};
  }
  Frame frame;
  encode(most, frame);
  Subscribe back;
  EXPECT_TRUE(decode(frame, back));
  frame.payload[0] = kMostSubscriptions + 1;
  frame.size += 7;
  std::memcpy(frame.payload + 1 + 7 * kMostSubscriptions, frame.payload + 1, 7);
  EXPECT_FALSE(decode(frame, back)) << "right except for their number";
  encode(Subscribe{1, {Subscription{GLIDER_M_DEPTH, 1, 3.0F}}}, frame);
  EXPECT_TRUE(decode(frame, back));
  frame.type = MessageType::Hello;
  EXPECT_FALSE(decode(frame, back));
}

TEST(TickEdges, EverySensorHasItsOwnBit) {
  for (const uint32_t count : {1U, 7U, 8U, 9U, 63U, 64U}) {
    Subscribe subscription;
    for (uint32_t i = 0; i < count; ++i) {
      subscription.sensors[subscription.count++] = {GLIDER_M_DEPTH, 1, 0};
    }
    for (uint32_t at = 0; at < count; ++at) {
      TickReadings readings;
      readings.told[at] = at % 2 == 0 ? ReadingReport::Value : ReadingReport::Unchanged;
      readings.values[at] = 3.5;
      Frame frame;
      encode(TickHead{}, subscription, readings, frame);
      ASSERT_EQ(frame.size, headBytes() + 2 * ((count + 7) / 8) + (at % 2 == 0 ? 4 : 0));
      TickReadings back;
      ASSERT_TRUE(decode(frame, subscription, back));
      for (uint32_t i = 0; i < count; ++i) {
        ASSERT_EQ(back.told[i], i == at ? readings.told[at] : ReadingReport::Nothing)
            << count << " " << i;
      }
    }
  }
}

template <typename Message>
bool comesBack(const Message& message) {
  Frame frame;
  encode(message, frame);
  Message back;
  return decode(frame, back);
}

TEST(MessageEdges, TimesThatAreNoneAreRefused) {
  for (const double time : {kNaN, kInfinity, -kInfinity}) {
    TransitionNotice notice;
    notice.mission_time_s = time;
    EXPECT_FALSE(comesBack(notice));
    MissionNote note;
    note.mission_time_s = time;
    EXPECT_FALSE(comesBack(note));
    EXPECT_FALSE(comesBack(Done{1, 0, {time}}));
  }
  EXPECT_TRUE(comesBack(TransitionNotice{}));
  EXPECT_TRUE(comesBack(MissionNote{}));
  EXPECT_TRUE(comesBack(Done{}));
}

TEST(MessageEdges, KindsAndListsUpToTheLast) {
  TransitionNotice notice;
  for (const uint8_t list : {uint8_t{0}, uint8_t{1}}) {
    notice.list = list;
    EXPECT_TRUE(comesBack(notice));
  }
  for (const uint8_t list : {uint8_t{2}, uint8_t{3}}) {
    notice.list = list;
    EXPECT_FALSE(comesBack(notice)) << "a profile's or a route's cases change no state";
  }
  MissionNote note;
  note.kind = 1;
  EXPECT_TRUE(comesBack(note));
  note.kind = 2;
  EXPECT_FALSE(comesBack(note));
  Hello hello;
  hello.link = 0;
  EXPECT_FALSE(comesBack(hello));
  hello.link = 1;
  EXPECT_TRUE(comesBack(hello));
}

TEST(MessageEdges, EveryFieldOfEveryMessageComesBack) {
  Frame frame;
  encode(TransitionNotice{1.5, 3, 0x01020304, 0x05060708, 0x090A0B0C, 1}, frame);
  TransitionNotice notice;
  ASSERT_TRUE(decode(frame, notice));
  EXPECT_EQ(notice.mission_time_s, 1.5);
  EXPECT_EQ(notice.transition, 3);
  EXPECT_EQ(notice.from, 0x01020304U);
  EXPECT_EQ(notice.to, 0x05060708U);
  EXPECT_EQ(notice.fired_case, 0x090A0B0CU);
  EXPECT_EQ(notice.list, 1);
  encode(Done{200, 0xABCDEF, {2.5, 0x01020304, 7, MissionPhase::Finished}}, frame);
  Done done;
  ASSERT_TRUE(decode(frame, done));
  EXPECT_EQ(done.answered, 200);
  EXPECT_EQ(done.session, 0xABCDEFU);
  EXPECT_EQ(done.status.mission_time_s, 2.5);
  EXPECT_EQ(done.status.state, 0x01020304U);
  EXPECT_EQ(done.status.stack_depth, 7);
  EXPECT_EQ(done.status.phase, MissionPhase::Finished);
  encode(Welcome{true, 0x123456, 0x654321}, frame);
  Welcome welcome;
  ASSERT_TRUE(decode(frame, welcome));
  EXPECT_TRUE(welcome.virtual_time);
  EXPECT_EQ(welcome.link, 0x123456U);
  EXPECT_EQ(welcome.newest_session, 0x654321U);
}

TEST(MessageEdges, TextsUpToTheirLongest) {
  MissionNote note;
  std::memset(note.text, 'x', kMostNoteBytes);
  Frame frame;
  encode(note, frame);
  MissionNote back;
  ASSERT_TRUE(decode(frame, back));
  EXPECT_EQ(std::strlen(back.text), kMostNoteBytes);
  Hello hello;
  hello.link = 1;
  std::memset(hello.mission_name, 'n', kMostNameBytes);
  encode(hello, frame);
  Hello again;
  ASSERT_TRUE(decode(frame, again));
  EXPECT_EQ(std::strlen(again.mission_name), kMostNameBytes);
}

TEST(MessageEdges, NewerIsLessThanHalfOfTheRoundAhead) {
  const uint32_t half = kMostSession / 2;
  EXPECT_TRUE(hookIsNewerSession(1 + half - 1, 1));
  EXPECT_FALSE(hookIsNewerSession(1 + half + 1, 1));
  EXPECT_TRUE(hookIsNewerSession(10, kMostSession - 10)) << "20 ahead, counting round";
  EXPECT_FALSE(hookIsNewerSession(kMostSession - 10, 10));
}

}  // namespace
}  // namespace glider::hooks
