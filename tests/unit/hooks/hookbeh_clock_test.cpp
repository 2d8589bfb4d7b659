// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/cycle_clock.h"

#include <gtest/gtest.h>

#include <limits>

namespace glider::hooks {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A clock that has seen 1000 s, 250 cycles.
CycleClock running() {
  CycleClock clock;
  clock.advance(996, 1e9 + 996, 249);
  clock.advance(1000, 1e9 + 1000, 250);
  return clock;
}

TEST(CycleClock, SaysHowLongACycleTook) {
  CycleClock clock = running();
  EXPECT_EQ(clock.step(), 4);
  clock.advance(1004.5, 1e9 + 1004.5, 251);
  EXPECT_EQ(clock.step(), 4.5);
  EXPECT_TRUE(clock.follows());
}

TEST(CycleClock, OneFalseReadingOfEitherClockIsACycle) {
  for (const double wrong : {60000.0, 1009.0, -5.0, 1000.0, 1e300, kNone}) {
    CycleClock clock = running();
    clock.advance(wrong, 1e9 + 1004, 251);
    EXPECT_EQ(clock.step(), 4) << wrong;
    clock.advance(1008, 1e9 + 1008, 252);
    EXPECT_EQ(clock.step(), 4) << "and back from " << wrong;
    clock = running();
    clock.advance(1004, wrong, 251);
    EXPECT_EQ(clock.step(), 4) << wrong;
    clock.advance(1008, 1e9 + 1008, 252);
    EXPECT_EQ(clock.step(), 4) << "and back from " << wrong;
  }
}

TEST(CycleClock, ACountedCycleTakesHalfASecondAtLeast) {
  CycleClock clock = running();
  clock.advance(1000.04, kNone, 251);
  EXPECT_EQ(clock.step(), 0.5);
  clock = running();
  clock.advance(1000.04, 1e9 + 1000.04, 251);
  EXPECT_EQ(clock.step(), 0.5) << "though both clocks do";
  clock = running();
  clock.advance(1000.25, 1e9 + 1000.25, 250);
  EXPECT_EQ(clock.step(), 0.25) << "not counted";
}

TEST(CycleClock, AfterALeapOfTheTimeTheClocksDoNotAgreeForTwoCycles) {
  CycleClock clock = running();
  clock.advance(60000, 1e9 + 1004, 251);
  EXPECT_FALSE(clock.follows());
  clock.advance(1008, 1e9 + 1008, 252);
  EXPECT_FALSE(clock.follows());
  clock.advance(1012, 1e9 + 1012, 253);
  EXPECT_TRUE(clock.follows());
}

TEST(CycleClock, AFalseCycleNumberChangesNothing) {
  for (const double wrong : {0.0, 1e7, 250.0, kNone}) {
    CycleClock clock = running();
    clock.advance(1004, 1e9 + 1004, wrong);
    EXPECT_EQ(clock.step(), 4) << wrong;
  }
}

TEST(CycleClock, AClockAloneIsComparedWithTheCycleNumber) {
  CycleClock clock;
  clock.advance(1000, kNone, 250);
  clock.advance(1009, kNone, 251);
  EXPECT_EQ(clock.step(), 4) << "more than twice what a cycle takes";
  clock.advance(1018, kNone, 254);
  EXPECT_EQ(clock.step(), 9) << "three cycles were missed";
  clock.advance(1058, kNone, 264);
  EXPECT_EQ(clock.step(), 4) << "ten are more than can be missed";
}

TEST(CycleClock, OfTwoPossibleStepsTheNearerToACycleCounts) {
  CycleClock clock = running();
  clock.advance(1007, 1e9 + 1004, 251);
  EXPECT_EQ(clock.step(), 4);
  clock = running();
  clock.advance(1004, 1e9 + 1007.5, 251);
  EXPECT_EQ(clock.step(), 4);
}

TEST(CycleClock, NoStepIsLongerThanTwentySeconds) {
  CycleClock clock = running();
  clock.advance(1300, 1e9 + 1300, 251);
  EXPECT_EQ(clock.step(), 20);
  clock.advance(1312, 1e9 + 1312, 252);
  EXPECT_EQ(clock.step(), 12) << "both clocks agree";
}

TEST(CycleClock, AStepOfOneClockAloneIsAtMostTwentySeconds) {
  CycleClock clock;
  clock.advance(1000, kNone, 250);
  clock.advance(1040, kNone, 255);
  EXPECT_EQ(clock.step(), 20) << "five cycles of twice their time";
  clock.advance(kNone, 1e9, 255);
  clock.advance(kNone, 1e9 + 24, 258);
  EXPECT_EQ(clock.step(), 20);
}

TEST(CycleClock, AClockAloneIsBelievedUpToTwiceACycle) {
  CycleClock clock;
  clock.advance(1000, kNone, kNone);
  clock.advance(1008, kNone, kNone);
  EXPECT_EQ(clock.step(), 8);
  EXPECT_TRUE(clock.follows());
  clock.advance(1016.25, kNone, kNone);
  EXPECT_EQ(clock.step(), 4);
  EXPECT_FALSE(clock.follows());
}

TEST(CycleClock, UpToFiveCyclesMayBeMissedAndNoneIsLessThanOne) {
  CycleClock clock;
  for (const double cycle : {250.0, 255.0}) {
    clock.advance(kNone, kNone, cycle);
  }
  EXPECT_EQ(clock.step(), 20);
  clock.advance(kNone, kNone, 261);
  EXPECT_EQ(clock.step(), 4) << "six";
  clock.advance(kNone, kNone, 261);
  EXPECT_EQ(clock.step(), 4) << "none";
  clock.advance(kNone, kNone, 250);
  EXPECT_EQ(clock.step(), 4) << "it counts back";
  clock.advance(kNone, kNone, 252);
  EXPECT_EQ(clock.step(), 8);
}

TEST(CycleClock, TimeThatDoesNotAdvanceByBothClocksIsACycle) {
  CycleClock clock = running();
  clock.advance(1000, 1e9 + 1000, 251);
  EXPECT_EQ(clock.step(), 4);
  EXPECT_FALSE(clock.follows());
}

TEST(CycleClock, ACycleMayBeAsShortAsItIs) {
  CycleClock clock = running();
  clock.advance(1000.5, 1e9 + 1000.5, 251);
  EXPECT_EQ(clock.step(), 0.5);
  clock.advance(1001, kNone, 252);
  EXPECT_EQ(clock.step(), 0.5) << "by one clock";
}

TEST(CycleClock, OfTwoThatAreEquallyNearTheMissionsCounts) {
  CycleClock clock = running();
  clock.advance(1003, 1e9 + 1005, 251);
  EXPECT_EQ(clock.step(), 3);
  clock = running();
  clock.advance(1005, 1e9 + 1003, 251);
  EXPECT_EQ(clock.step(), 5);
}

TEST(CycleClock, TwoClocksThatDifferByASecondAgree) {
  CycleClock clock = running();
  clock.advance(1010, 1e9 + 1011, 251);
  EXPECT_EQ(clock.step(), 10);
  EXPECT_TRUE(clock.follows());
}

TEST(CycleClock, TwoClocksThatDifferByMoreThanASecondDoNotAgree) {
  CycleClock clock = running();
  clock.advance(1030, 1e9 + 1031.5, 251);
  EXPECT_EQ(clock.step(), 4);
  clock = running();
  clock.advance(1019, 1e9 + 1019.5, 251);
  EXPECT_EQ(clock.step(), 19);
}

TEST(CycleClock, WithoutAnyClockAStepIsOneCycle) {
  CycleClock clock;
  for (int i = 0; i < 3; ++i) {
    clock.advance(kNone, kNone, kNone);
    EXPECT_EQ(clock.step(), 4);
    EXPECT_FALSE(clock.follows());
  }
}

}  // namespace
}  // namespace glider::hooks
