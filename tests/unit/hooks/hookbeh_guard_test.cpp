// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/hull.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <tuple>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

Bench diving() {
  Bench bench;
  bench.cycle();
  bench.give(Bench::take(29));
  return bench;
}

TEST(HookbehGuard, TooDeepClimbsAgainstAnyInstruction) {
  Bench bench = diving();
  bench.inputs.depth_m = 30.1;
  HookbehOutputs out = bench.cycle();
  EXPECT_STREQ(wordsFor(out.doing), "climb: too deep");
  EXPECT_EQ(out.pump_cc, kHull.pump_cc);
  EXPECT_GT(out.pitch_rad, 0);
  EXPECT_STREQ(wordsFor(bench.give(Bench::descend(30)).doing), "climb: too deep") << "another dive";
  bench.inputs.depth_m = 20;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too deep")
      << "its target is less than a metre from the limit";
  EXPECT_STREQ(wordsFor(bench.give(Bench::ascend(5)).doing), "climb_to");
  EXPECT_STREQ(wordsFor(bench.give(Bench::descend(30)).doing), "dive_to") << "free again";
}

TEST(HookbehGuard, ADiveThatKeepsTheLimitsGoesOnOnceTheVehicleIsClear) {
  Bench bench = diving();
  bench.inputs.depth_m = 30.1;
  bench.cycle();
  bench.inputs.depth_m = 29.1;
  EXPECT_STREQ(wordsFor(bench.give(Bench::descend(28)).doing), "climb: too deep");
  bench.inputs.depth_m = 28.9;
  EXPECT_EQ(bench.cycle().guard, HookGuard::None);
}

TEST(HookbehGuard, OverABumpTheDiveGoesOn) {
  Bench bench = diving();
  bench.inputs.depth_m = 15;
  bench.inputs.altitude_m = 4.9;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom");
  bench.inputs.depth_m = 13;
  bench.inputs.altitude_m = 20.9;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom")
      << "29 m would be too near still";
  bench.inputs.altitude_m = 22.5;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
}

TEST(HookbehGuard, OverAShallowBottomTheDiveIsTriedAgainFromHalfItsDepth) {
  Bench bench = diving();
  for (int round = 0; round < 3; ++round) {
    bench.inputs.depth_m = 17.1;
    bench.inputs.altitude_m = 4.9;
    EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom");
    bench.inputs.depth_m = 8.7;
    bench.inputs.altitude_m = 13.3;
    EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom");
    bench.inputs.depth_m = 8.5;
    bench.inputs.altitude_m = 13.5;
    EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
  }
}

/// Arrived at its target, with a bottom that has risen so far that the guard intervenes, at 20 m.
Bench overABump(Instruction instruction) {
  Bench bench;
  bench.cycle();
  bench.inputs.depth_m = 20;
  instruction.control = HookControl::Take;
  bench.give(instruction);
  for (int i = 0; i < 4; ++i) {
    bench.cycle();  // what it held it has held
  }
  bench.inputs.altitude_m = 4.9;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom");
  return bench;
}

TEST(HookbehGuard, AHoverThatWasReachedIsReachedAgainAtPitch) {
  Bench bench = overABump(Bench::vertical(HookVertical::Hover, 20));
  bench.inputs.depth_m = 12;
  bench.inputs.altitude_m = 60;
  HookbehOutputs out = bench.cycle();
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
  EXPECT_NEAR(out.pitch_rad, -0.4538, 1e-9);
  EXPECT_EQ(out.pump_cc, -230);
  bench.inputs.depth_m = 18;
  out = bench.cycle();
  EXPECT_STREQ(wordsFor(out.doing), "hover");
  EXPECT_EQ(out.pitch_rad, 0);
}

TEST(HookbehGuard, ADescendThatHadArrivedDivesAgain) {
  Bench bench = overABump(Bench::descend(20));
  bench.inputs.depth_m = 12;
  bench.inputs.altitude_m = 60;
  HookbehOutputs out = bench.cycle();
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
  EXPECT_EQ(out.pitch_rad, -0.4) << "as instructed";
  bench.inputs.depth_m = 20;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "hold");
}

TEST(HookbehGuard, AnAscendThatHadArrivedComesBackToItsDepthAtPitch) {
  Bench bench = overABump(Bench::ascend(20));
  bench.inputs.depth_m = 12;
  bench.inputs.altitude_m = 60;
  HookbehOutputs out = bench.cycle();
  EXPECT_STREQ(wordsFor(out.doing), "dive_to");
  EXPECT_NEAR(out.pitch_rad, -0.4538, 1e-9);
  bench.inputs.depth_m = 18;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "hover")
      << "no dive was commanded that might be held";
}

TEST(HookbehGuard, AnAscendWhoseTargetIsTooLowDoesNotSwingByAMetre) {
  Bench bench = overABump(Bench::ascend(20));
  for (double depth = 18.8; depth > 10; depth -= 0.8) {
    bench.inputs.depth_m = depth;
    bench.inputs.altitude_m = 24.9 - depth;
    EXPECT_NE(bench.cycle().guard, HookGuard::None) << depth << " m is clear, but 20 m is not";
  }
  bench.inputs.depth_m = 10;
  bench.inputs.altitude_m = 14.9;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to") << "half of the depth";
}

TEST(HookbehGuard, NearItsTargetItHoversOn) {
  Bench bench = overABump(Bench::vertical(HookVertical::Hover, 20));
  bench.inputs.depth_m = 18.2;
  bench.inputs.altitude_m = 60;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "hover");
  for (const double depth : {16.0, 24.0, 17.0}) {
    bench.inputs.depth_m = depth;
    EXPECT_STREQ(wordsFor(bench.cycle().doing), "hover") << "its own swing is not the guard's";
  }
}

TEST(HookbehGuard, AHoverIsReachedAgainAfterTheDepthWasUnknown) {
  Bench bench;
  bench.cycle();
  bench.inputs.depth_m = 20;
  Instruction hover = Bench::vertical(HookVertical::Hover, 20);
  hover.control = HookControl::Take;
  EXPECT_STREQ(wordsFor(bench.give(hover).doing), "hover");
  bench.inputs.depth_m = kNan;
  EXPECT_NE(bench.cycle().guard, HookGuard::None);
  EXPECT_NE(bench.give(Bench::vertical(HookVertical::Hover, 21)).guard, HookGuard::None);
  bench.inputs.depth_m = 15;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
}

TEST(HookbehGuard, InVeryShallowWaterItStaysUpUntilTheBottomIsForgotten) {
  Bench bench = diving();
  bench.inputs.depth_m = 4.9;
  bench.inputs.altitude_m = 4.9;
  bench.cycle();
  bench.inputs.depth_m = 0;
  for (int i = 0; i < 148; ++i) {
    EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom") << i;
  }
  bench.cycle();
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to") << "after 10 minutes it tries again";
}

TEST(HookbehGuard, ACommandToClimbDoesNotEndItBeforeTheDepthIsSafe) {
  Bench bench = diving();
  bench.inputs.depth_m = 30.1;
  bench.cycle();
  EXPECT_STREQ(wordsFor(bench.give(Bench::ascend(5)).doing), "climb: too deep");
  bench.inputs.depth_m = 29.5;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too deep");
  bench.inputs.depth_m = 29;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb_to");
}

TEST(HookbehGuard, HoverEndsItOnlyAMetreClearOfTheLimit) {
  Bench bench = diving();
  bench.inputs.depth_m = 30.1;
  bench.cycle();
  EXPECT_STREQ(wordsFor(bench.give(Bench::vertical(HookVertical::Hover, 29.5)).doing),
               "climb: too deep");
  bench.inputs.depth_m = 20;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too deep");
  EXPECT_STREQ(wordsFor(bench.give(Bench::vertical(HookVertical::Hover, 20)).doing), "hover");
}

TEST(HookbehGuard, TooNearTheBottomClimbs) {
  Bench bench = diving();
  bench.inputs.depth_m = 15;
  bench.inputs.altitude_m = 5.5;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
  bench.inputs.depth_m = 15.4;
  bench.inputs.altitude_m = 4.9;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom");
  bench.inputs.depth_m = 10;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom");
  EXPECT_STREQ(wordsFor(bench.give(Bench::ascend(5)).doing), "climb_to");
}

TEST(HookbehGuard, AStuckAltimeterDoesNotHideTheBottom) {
  Bench bench = diving();
  bench.inputs.depth_m = 12;
  bench.inputs.altitude_m = 10;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
  bench.inputs.depth_m = 17.5;  // the altitude still says 10
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom");
}

TEST(HookbehGuard, OneFalseReadingOfTheTimeDoesNotForgetTheBottom) {
  Bench bench = diving();
  bench.inputs.depth_m = 12;
  bench.inputs.altitude_m = 6;
  bench.cycle();
  bench.inputs.time_s += 60000;
  bench.cycle();
  bench.inputs.time_s -= 60000;
  bench.cycle();
  bench.inputs.depth_m = 13.5;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "climb: too near the bottom");
}

TEST(HookbehGuard, TheShallowestBreakOfALimitCountsForTheNextTry) {
  Bench bench = diving();
  bench.inputs.depth_m = 20;
  bench.inputs.altitude_m = 4.9;
  EXPECT_EQ(bench.cycle().guard, HookGuard::NearBottom);
  bench.inputs.depth_m = 18.5;
  bench.inputs.altitude_m = 4.8;
  EXPECT_EQ(bench.cycle().guard, HookGuard::NearBottom) << "the bottom rises";
  bench.inputs.depth_m = 9.6;
  bench.inputs.altitude_m = 13.7;
  EXPECT_EQ(bench.cycle().guard, HookGuard::NearBottom) << "half of 20 m, not of 18.5 m";
  bench.inputs.depth_m = 9.2;
  EXPECT_EQ(bench.cycle().guard, HookGuard::None);
}

TEST(HookbehGuard, ADiveTowardsTheBottomTurnsSoonerTheFasterItSinks) {
  for (const auto& [rate, altitude, turns] : {std::tuple{0.0, 5.5, false},
                                              {0.1, 5.5, true},
                                              {0.25, 6.9, true},
                                              {0.25, 7.1, false},
                                              {2.0, 8.9, true},
                                              {2.0, 9.1, false},
                                              {-1.0, 5.5, false},
                                              {kNan, 5.5, false}}) {
    Bench bench = diving();
    bench.inputs.depth_m = 15;
    bench.inputs.depth_rate_mps = rate;
    bench.inputs.altitude_m = altitude;
    EXPECT_EQ(bench.cycle().guard != HookGuard::None, turns) << rate << " m/s, " << altitude;
  }
}

TEST(HookbehGuard, ATargetThatIsClearOfTheBottomIsReachedHoweverFastItSinks) {
  Bench bench = diving();
  bench.give(Bench::descend(18));
  bench.inputs.depth_m = 17;
  bench.inputs.depth_rate_mps = 0.4;
  bench.inputs.altitude_m = 7.5;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
}

TEST(HookbehGuard, NoAltimeterUsed) {
  HookbehArgs args;
  args.least_altitude_m = -1;
  Bench bench(args);
  bench.cycle();
  bench.give(Bench::take(20));
  bench.inputs.altitude_m = 0.5;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
}

TEST(HookbehGuard, NoEchoMeansNoBottom) {
  Bench bench = diving();
  for (const double altitude : {kNan, -1.0}) {
    bench.inputs.altitude_m = altitude;
    EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
  }
}

TEST(HookbehGuard, UnknownDepthClimbsUntilItIsKnown) {
  Bench bench = diving();
  bench.inputs.depth_m = kNan;
  const HookbehOutputs out = bench.cycle();
  EXPECT_STREQ(wordsFor(out.doing), "climb: depth unknown");
  EXPECT_EQ(out.pump_cc, kHull.pump_cc);
  bench.inputs.depth_m = 12;
  EXPECT_STREQ(wordsFor(bench.cycle().doing), "dive_to");
}

TEST(HookbehGuard, ANewSessionStartsWithoutTheOldReasons) {
  Bench bench = diving();
  bench.inputs.depth_m = 30.1;
  bench.cycle();
  bench.alive = false;
  bench.inputs.depth_m = 10;
  for (int i = 0; i < 6; ++i) {
    bench.cycle();
  }
  bench.alive = true;
  EXPECT_STREQ(wordsFor(bench.give(Bench::take(20, 2)).doing), "dive_to");
}

TEST(HookbehGuard, ANanAmongTheArgsIsABrokenLimit) {
  HookbehArgs args;
  args.least_altitude_m = kNan;
  Bench bench(args);
  bench.cycle();
  bench.inputs.altitude_m = 50;
  EXPECT_STREQ(wordsFor(bench.give(Bench::take(20)).doing), "climb: too near the bottom");
}

}  // namespace
}  // namespace glider::hooks
