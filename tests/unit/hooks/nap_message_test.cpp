// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The message Nap, and the mark of a Tick that was kept.

#include "hooks/protocol/nap.h"
#include "hooks/seat/tick_ring.h"
#include "tests/unit/hooks/examples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <deque>
#include <limits>
#include <random>

namespace glider::hooks {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Nap example() {
  Nap nap{60, 600, 3, {}};
  nap.conditions[0] = {GLIDER_M_DEPTH, NapKind::AtLeast, 20.5};
  nap.conditions[1] = {GLIDER_M_BATTERY, NapKind::AtMost, 12};
  nap.conditions[2] = {GLIDER_M_LAT, NapKind::Known, 0};
  return nap;
}

bool taken(const Nap& nap) {
  Frame frame;
  encode(nap, frame);
  Nap back;
  return decode(frame, exampleSubscription(), back);
}

bool takenWith(const NapCondition& condition) {
  Nap nap = example();
  nap.conditions[1] = condition;
  return taken(nap);
}

TEST(NapMessage, ComesBack) {
  Frame frame;
  encode(example(), frame);
  EXPECT_EQ(frame.type, MessageType::Nap);
  EXPECT_EQ(frame.size, 4 + 3 * 11);
  Nap back;
  ASSERT_TRUE(decode(frame, exampleSubscription(), back));
  EXPECT_EQ(back.wake_s, 60);
  EXPECT_EQ(back.length_s, 600);
  ASSERT_EQ(back.count, 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(back.conditions[i].id, example().conditions[i].id);
    EXPECT_EQ(back.conditions[i].kind, example().conditions[i].kind);
    EXPECT_EQ(back.conditions[i].value, example().conditions[i].value);
  }
}

TEST(NapMessage, TheValueOfKnownIsNotSentAndNotRead) {
  Nap nap = example();
  nap.conditions[2].value = 5;
  Frame frame, same;
  encode(nap, frame);
  encode(example(), same);
  EXPECT_EQ(std::memcmp(frame.payload, same.payload, same.size), 0);
  std::memset(frame.payload + frame.size - 8, 0xFF, 8);  // a NaN
  Nap back;
  EXPECT_TRUE(decode(frame, exampleSubscription(), back));
}

TEST(NapMessage, HasAtMost32Conditions) {
  Nap nap{1, 1, 32, {}};
  for (NapCondition& condition : nap.conditions) {
    condition = {GLIDER_M_DEPTH, NapKind::AtMost, 1};
  }
  EXPECT_TRUE(taken(nap));
  Frame frame;
  nap.count = 33;
  encode(nap, frame);
  EXPECT_EQ(frame.size, 4 + 32 * 11) << "no more are sent";
  frame.payload[3] = 33;
  std::memcpy(frame.payload + frame.size, frame.payload + 4, 11);
  frame.size = 4 + 33 * 11;
  Nap back;
  EXPECT_FALSE(decode(frame, exampleSubscription(), back));
  EXPECT_TRUE(taken({0, 1, 0, {}})) << "none";
}

TEST(NapMessage, IsRefusedAsAWholeForOnePartThatNoSenderWrites) {
  EXPECT_TRUE(takenWith({GLIDER_M_DEPTH, NapKind::AtMost, -kInfinity}));
  EXPECT_FALSE(takenWith({GLIDER_M_DEPTH, NapKind::AtLeast, kUnknown}));
  EXPECT_FALSE(takenWith({GLIDER_M_DEPTH, NapKind::AtMost, kUnknown}));
  EXPECT_FALSE(takenWith({GLIDER_M_DEPTH, static_cast<NapKind>(4), 1}));
  EXPECT_FALSE(takenWith({GLIDER_M_PITCH, NapKind::AtMost, 1})) << "not subscribed";
  EXPECT_FALSE(takenWith({GLIDER_SENSOR_COUNT, NapKind::Known, 0})) << "no such sensor";
  EXPECT_FALSE(takenWith({0xFFFF, NapKind::Known, 0}));
  Nap none = example();
  none.length_s = 0;
  EXPECT_FALSE(taken(none));
}

TEST(NapMessage, IsRefusedAtAnyOtherLengthOrType) {
  Frame frame;
  encode(example(), frame);
  const uint16_t size = frame.size;
  Nap back;
  for (uint32_t other = 0; other <= kMostPayload; ++other) {
    frame.size = static_cast<uint16_t>(other);
    EXPECT_EQ(decode(frame, exampleSubscription(), back), other == size) << other;
  }
  frame.size = size;
  frame.type = MessageType::Write;
  EXPECT_FALSE(decode(frame, exampleSubscription(), back));
}

TEST(NapMessage, ConditionsHoldAtTheirValueAndNeverForAnUnknownOne) {
  const auto holds = [](NapKind kind, double than, double value) {
    const NapCondition condition{1, kind, than};
    return hookNapConditionHolds(&condition, value);
  };
  EXPECT_TRUE(holds(NapKind::AtLeast, 3, 3));
  EXPECT_FALSE(holds(NapKind::AtLeast, 3, 2.999));
  EXPECT_TRUE(holds(NapKind::AtMost, 3, 3));
  EXPECT_FALSE(holds(NapKind::AtMost, 3, 3.001));
  EXPECT_TRUE(holds(NapKind::Known, 0, -7));
  for (const NapKind kind : {NapKind::AtLeast, NapKind::AtMost, NapKind::Known}) {
    EXPECT_FALSE(holds(kind, 0, kUnknown));
  }
}

TEST(TickKept, IsAMarkOfItsOwnThatCanBeSetAndCleared) {
  TickHead head;
  head.virtual_time = true;
  head.kept = true;
  Frame frame;
  encode(head, exampleSubscription(), exampleReadings(), frame);
  for (const bool kept : {true, false, false, true}) {
    hookMarkTickKept(&frame, kept);
    TickHead back;
    ASSERT_TRUE(decode(frame, back));
    EXPECT_EQ(back.kept, kept);
    EXPECT_TRUE(back.virtual_time);
  }
}

TEST(TickKept, TheGreatestTickIsAsLongAsThatOfAllValues) {
  Subscribe subscription = exampleSubscription();
  TickReadings all;
  for (auto& told : all.told) {
    told = ReadingReport::Value;
  }
  for (; subscription.count <= kMostSubscriptions; ++subscription.count) {
    Frame frame;
    encode({}, subscription, all, frame);
    EXPECT_EQ(hookGreatestTick(&gliderDictionary, &subscription), frame.size);
    if (subscription.count < kMostSubscriptions) {
      subscription.sensors[subscription.count] = {subscription.count, 1, 0};
    }
  }
}

/// Frames of all sizes go through the ring many times, past its end.
TEST(TickRing, GivesBackWhatItTookInOrderWhereverItsBytesLie) {
  static HookTickRing ring;
  std::mt19937 random(5);
  std::deque<Frame> inside;
  size_t through = 0;
  while (through < 2000) {
    Frame frame;
    frame.type = MessageType::Tick;
    frame.sequence = static_cast<uint8_t>(random());
    frame.size = static_cast<uint16_t>(random() % (kMostPayload + 1));
    for (uint32_t i = 0; i < frame.size; ++i) {
      frame.payload[i] = static_cast<uint8_t>(random());
    }
    const bool fits = hookTickRingHasRoom(&ring, 1, frame.size);
    EXPECT_EQ(hookTickRingAdd(&ring, &frame), fits);
    if (fits) {
      inside.push_back(frame);
      EXPECT_LE(ring.used, uint32_t{kHookTickRingBytes});
    }
    for (auto n = random() % 3; (n > 0 || !fits) && !inside.empty(); --n) {
      Frame oldest;
      ASSERT_TRUE(hookTickRingOldest(&ring, &oldest));
      hookTickRingDropOldest(&ring);
      EXPECT_EQ(oldest.type, inside.front().type);
      EXPECT_EQ(oldest.sequence, inside.front().sequence);
      ASSERT_EQ(oldest.size, inside.front().size);
      EXPECT_EQ(std::memcmp(oldest.payload, inside.front().payload, oldest.size), 0);
      inside.pop_front();
      ++through;
      if (n == 0) {
        break;
      }
    }
  }
}

TEST(TickRing, HoldsAsManyBytesAndTicksAsItSays) {
  static HookTickRing ring;
  Frame frame;
  frame.size = 1;
  for (int i = 0; i < kHookMostKeptTicks; ++i) {
    EXPECT_TRUE(hookTickRingAdd(&ring, &frame)) << i;
  }
  EXPECT_FALSE(hookTickRingAdd(&ring, &frame));
  hookTickRingClear(&ring);
  frame.size = 508;  // 512 with its head
  for (int i = 0; i < 32; ++i) {
    EXPECT_TRUE(hookTickRingHasRoom(&ring, 32U - static_cast<uint32_t>(i), 508));
    EXPECT_TRUE(hookTickRingAdd(&ring, &frame)) << i;
  }
  EXPECT_FALSE(hookTickRingHasRoom(&ring, 1, 0));
  EXPECT_FALSE(hookTickRingAdd(&ring, &frame));
}

}  // namespace
}  // namespace glider::hooks
