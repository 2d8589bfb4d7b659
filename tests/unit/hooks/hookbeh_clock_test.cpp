// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/cycle_clock.h"
#include "tests/unit/hooks/begun.h"

#include <gtest/gtest.h>

#include <limits>

namespace glider::hooks {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A clock that has seen 1000 s, 250 cycles.
HookCycleClock running() {
  HookCycleClock clock = begun(hookCycleClockInit);
  hookCycleClockAdvance(&clock, 996, 1e9 + 996, 249);
  hookCycleClockAdvance(&clock, 1000, 1e9 + 1000, 250);
  return clock;
}

TEST(CycleClock, SaysHowLongACycleTook) {
  HookCycleClock clock = running();
  EXPECT_EQ(clock.step_s, 4);
  hookCycleClockAdvance(&clock, 1004.5, 1e9 + 1004.5, 251);
  EXPECT_EQ(clock.step_s, 4.5);
  EXPECT_TRUE(clock.follows);
}

TEST(CycleClock, OneFalseReadingOfEitherClockIsACycle) {
  for (const double wrong : {60000.0, 1009.0, -5.0, 1000.0, 1e300, kNone}) {
    HookCycleClock clock = running();
    hookCycleClockAdvance(&clock, wrong, 1e9 + 1004, 251);
    EXPECT_EQ(clock.step_s, 4) << wrong;
    hookCycleClockAdvance(&clock, 1008, 1e9 + 1008, 252);
    EXPECT_EQ(clock.step_s, 4) << "and back from " << wrong;
    clock = running();
    hookCycleClockAdvance(&clock, 1004, wrong, 251);
    EXPECT_EQ(clock.step_s, 4) << wrong;
    hookCycleClockAdvance(&clock, 1008, 1e9 + 1008, 252);
    EXPECT_EQ(clock.step_s, 4) << "and back from " << wrong;
  }
}

TEST(CycleClock, ACountedCycleTakesHalfASecondAtLeast) {
  HookCycleClock clock = running();
  hookCycleClockAdvance(&clock, 1000.04, kNone, 251);
  EXPECT_EQ(clock.step_s, 0.5);
  clock = running();
  hookCycleClockAdvance(&clock, 1000.04, 1e9 + 1000.04, 251);
  EXPECT_EQ(clock.step_s, 0.5) << "though both clocks do";
  clock = running();
  hookCycleClockAdvance(&clock, 1000.25, 1e9 + 1000.25, 250);
  EXPECT_EQ(clock.step_s, 0.25) << "not counted";
}

TEST(CycleClock, AfterALeapOfTheTimeTheClocksDoNotAgreeForTwoCycles) {
  HookCycleClock clock = running();
  hookCycleClockAdvance(&clock, 60000, 1e9 + 1004, 251);
  EXPECT_FALSE(clock.follows);
  hookCycleClockAdvance(&clock, 1008, 1e9 + 1008, 252);
  EXPECT_FALSE(clock.follows);
  hookCycleClockAdvance(&clock, 1012, 1e9 + 1012, 253);
  EXPECT_TRUE(clock.follows);
}

TEST(CycleClock, AFalseCycleNumberChangesNothing) {
  for (const double wrong : {0.0, 1e7, 250.0, kNone}) {
    HookCycleClock clock = running();
    hookCycleClockAdvance(&clock, 1004, 1e9 + 1004, wrong);
    EXPECT_EQ(clock.step_s, 4) << wrong;
  }
}

TEST(CycleClock, AClockAloneIsComparedWithTheCycleNumber) {
  HookCycleClock clock = begun(hookCycleClockInit);
  hookCycleClockAdvance(&clock, 1000, kNone, 250);
  hookCycleClockAdvance(&clock, 1009, kNone, 251);
  EXPECT_EQ(clock.step_s, 4) << "more than twice what a cycle takes";
  hookCycleClockAdvance(&clock, 1018, kNone, 254);
  EXPECT_EQ(clock.step_s, 9) << "three cycles were missed";
  hookCycleClockAdvance(&clock, 1058, kNone, 264);
  EXPECT_EQ(clock.step_s, 4) << "ten are more than can be missed";
}

TEST(CycleClock, OfTwoPossibleStepsTheNearerToACycleCounts) {
  HookCycleClock clock = running();
  hookCycleClockAdvance(&clock, 1007, 1e9 + 1004, 251);
  EXPECT_EQ(clock.step_s, 4);
  clock = running();
  hookCycleClockAdvance(&clock, 1004, 1e9 + 1007.5, 251);
  EXPECT_EQ(clock.step_s, 4);
}

TEST(CycleClock, NoStepIsLongerThanTwentySeconds) {
  HookCycleClock clock = running();
  hookCycleClockAdvance(&clock, 1300, 1e9 + 1300, 251);
  EXPECT_EQ(clock.step_s, 20);
  hookCycleClockAdvance(&clock, 1312, 1e9 + 1312, 252);
  EXPECT_EQ(clock.step_s, 12) << "both clocks agree";
}

TEST(CycleClock, AStepOfOneClockAloneIsAtMostTwentySeconds) {
  HookCycleClock clock = begun(hookCycleClockInit);
  hookCycleClockAdvance(&clock, 1000, kNone, 250);
  hookCycleClockAdvance(&clock, 1040, kNone, 255);
  EXPECT_EQ(clock.step_s, 20) << "five cycles of twice their time";
  hookCycleClockAdvance(&clock, kNone, 1e9, 255);
  hookCycleClockAdvance(&clock, kNone, 1e9 + 24, 258);
  EXPECT_EQ(clock.step_s, 20);
}

TEST(CycleClock, AClockAloneIsBelievedUpToTwiceACycle) {
  HookCycleClock clock = begun(hookCycleClockInit);
  hookCycleClockAdvance(&clock, 1000, kNone, kNone);
  hookCycleClockAdvance(&clock, 1008, kNone, kNone);
  EXPECT_EQ(clock.step_s, 8);
  EXPECT_TRUE(clock.follows);
  hookCycleClockAdvance(&clock, 1016.25, kNone, kNone);
  EXPECT_EQ(clock.step_s, 4);
  EXPECT_FALSE(clock.follows);
}

TEST(CycleClock, UpToFiveCyclesMayBeMissedAndNoneIsLessThanOne) {
  HookCycleClock clock = begun(hookCycleClockInit);
  for (const double cycle : {250.0, 255.0}) {
    hookCycleClockAdvance(&clock, kNone, kNone, cycle);
  }
  EXPECT_EQ(clock.step_s, 20);
  hookCycleClockAdvance(&clock, kNone, kNone, 261);
  EXPECT_EQ(clock.step_s, 4) << "six";
  hookCycleClockAdvance(&clock, kNone, kNone, 261);
  EXPECT_EQ(clock.step_s, 4) << "none";
  hookCycleClockAdvance(&clock, kNone, kNone, 250);
  EXPECT_EQ(clock.step_s, 4) << "it counts back";
  hookCycleClockAdvance(&clock, kNone, kNone, 252);
  EXPECT_EQ(clock.step_s, 8);
}

TEST(CycleClock, TimeThatDoesNotAdvanceByBothClocksIsACycle) {
  HookCycleClock clock = running();
  hookCycleClockAdvance(&clock, 1000, 1e9 + 1000, 251);
  EXPECT_EQ(clock.step_s, 4);
  EXPECT_FALSE(clock.follows);
}

TEST(CycleClock, ACycleMayBeAsShortAsItIs) {
  HookCycleClock clock = running();
  hookCycleClockAdvance(&clock, 1000.5, 1e9 + 1000.5, 251);
  EXPECT_EQ(clock.step_s, 0.5);
  hookCycleClockAdvance(&clock, 1001, kNone, 252);
  EXPECT_EQ(clock.step_s, 0.5) << "by one clock";
}

TEST(CycleClock, OfTwoThatAreEquallyNearTheMissionsCounts) {
  HookCycleClock clock = running();
  hookCycleClockAdvance(&clock, 1003, 1e9 + 1005, 251);
  EXPECT_EQ(clock.step_s, 3);
  clock = running();
  hookCycleClockAdvance(&clock, 1005, 1e9 + 1003, 251);
  EXPECT_EQ(clock.step_s, 5);
}

TEST(CycleClock, TwoClocksThatDifferByASecondAgree) {
  HookCycleClock clock = running();
  hookCycleClockAdvance(&clock, 1010, 1e9 + 1011, 251);
  EXPECT_EQ(clock.step_s, 10);
  EXPECT_TRUE(clock.follows);
}

TEST(CycleClock, TwoClocksThatDifferByMoreThanASecondDoNotAgree) {
  HookCycleClock clock = running();
  hookCycleClockAdvance(&clock, 1030, 1e9 + 1031.5, 251);
  EXPECT_EQ(clock.step_s, 4);
  clock = running();
  hookCycleClockAdvance(&clock, 1019, 1e9 + 1019.5, 251);
  EXPECT_EQ(clock.step_s, 19);
}

TEST(CycleClock, WithoutAnyClockAStepIsOneCycle) {
  HookCycleClock clock = begun(hookCycleClockInit);
  for (int i = 0; i < 3; ++i) {
    hookCycleClockAdvance(&clock, kNone, kNone, kNone);
    EXPECT_EQ(clock.step_s, 4);
    EXPECT_FALSE(clock.follows);
  }
}

}  // namespace
}  // namespace glider::hooks
