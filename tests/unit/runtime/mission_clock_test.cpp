// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Mission time by the vehicle's clock, and by the SBC's own where that is silent or wrong.

#include "runtime/core/mission_clock.h"

#include <gtest/gtest.h>

namespace glider::runtime {
namespace {

TEST(MissionClock, NoVehicleTimeStopsItOrCarriesItAway) {
  for (const double wrong : {1e30, 3.4e38, 1e6, 60000.0, 540.0, -1e30}) {
    MissionClock clock;
    clock.start(100, 0);
    EXPECT_EQ(clock.atFrame(500, 125, 400), 400);
    EXPECT_EQ(clock.atFrame(wrong, 126, 404), 404) << wrong;
    EXPECT_EQ(clock.atFrame(wrong, 127, 408), 404) << wrong;
    EXPECT_EQ(clock.withoutFrame(420), 416);
    EXPECT_EQ(clock.atFrame(528, 132, 432), 428) << wrong;
    EXPECT_EQ(clock.atFrame(532, 133, 436), 432) << wrong;
  }
}

/// The frames of a sleep that the vehicle has kept come later, with their own times.
TEST(MissionClock, ASleepBeforeSilenceDoesNotCount) {
  for (const double woken : {640.0, 1e6}) {  // in time, or by a clock that jumps
    MissionClock clock;
    clock.start(100, 0);
    EXPECT_EQ(clock.atFrame(500, 125, 400), 400);
    clock.sleeps(240);
    EXPECT_EQ(clock.withoutFrame(woken), 416);
    EXPECT_EQ(clock.withoutFrame(woken + 12), 428);
    EXPECT_EQ(clock.atKeptFrame(504, 126, woken + 13), 404);
    EXPECT_EQ(clock.atKeptFrame(740, 185, woken + 13), 640);
    EXPECT_EQ(clock.atFrame(744, 186, woken + 14), 644);
  }
}

TEST(MissionClock, ASleepCountsIfTheVehicleThenRestarts) {
  MissionClock clock;
  clock.start(100, 0);
  EXPECT_EQ(clock.atFrame(500, 125, 400), 400);
  clock.sleeps(240);
  EXPECT_EQ(clock.withoutFrame(640), 416);
  EXPECT_EQ(clock.atFrame(4, 1, 644), 644);
  EXPECT_EQ(clock.atFrame(8, 2, 648), 648) << "and only once";
  EXPECT_EQ(clock.withoutFrame(660), 660);
}

TEST(MissionClock, OverARestartOfTheVehicleTheSbcsClockCounts) {
  MissionClock clock;
  clock.start(100, 0);
  EXPECT_EQ(clock.atFrame(500, 125, 400), 400);
  EXPECT_EQ(clock.withoutFrame(412), 412);
  EXPECT_EQ(clock.atFrame(4, 1, 424), 424) << "20 s after the last frame";
  EXPECT_EQ(clock.atFrame(8, 2, 428), 428);
  EXPECT_EQ(clock.atFrame(4, 1, 700), 444) << "a clock that jumps adds 16 s at most";
}

TEST(MissionClock, OneFalseReadingCostsAtMostTwoCycles) {
  for (const double wrong : {60000.0, 1020.1, 3.0}) {
    MissionClock clock;
    clock.start(0, 0);
    EXPECT_EQ(clock.atFrame(1000, 250, 0), 1000);
    EXPECT_EQ(clock.atFrame(wrong, 251, 0), 1000) << wrong;
    EXPECT_EQ(clock.atFrame(1008, 252, 0), 1000) << wrong;
    EXPECT_EQ(clock.atFrame(1012, 253, 0), 1004) << wrong;
  }
}

TEST(MissionClock, AFalseCycleNumberChangesNothing) {
  for (const uint32_t wrong : {0U, 250U, 16777215U}) {
    MissionClock clock;
    clock.start(0, 0);
    EXPECT_EQ(clock.atFrame(1000, 250, 0), 1000);
    EXPECT_EQ(clock.atFrame(1004, wrong, 0), 1004);
    EXPECT_EQ(clock.atFrame(1008, 252, 0), 1008);
  }
}

TEST(MissionClock, ALongSilenceIsCaughtUpWith) {
  MissionClock clock;
  clock.start(0, 0);
  EXPECT_EQ(clock.atFrame(40, 10, 40), 40);
  EXPECT_EQ(clock.atFrame(40040, 10010, 40), 40040) << "the SBC's clock did not advance";
  EXPECT_EQ(clock.withoutFrame(60), 40056);
  EXPECT_EQ(clock.atFrame(40052, 10013, 60), 40052) << "its own ran ahead";
}

}  // namespace
}  // namespace glider::runtime
