// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the small parts of hookbeh do at the very edges, each by itself.

#include "hooks/hookbeh/depth_source.h"
#include "hooks/hookbeh/headway.h"
#include "hooks/hookbeh/hover.h"
#include "hooks/hookbeh/pilot.h"
#include "hooks/hookbeh/recent_depths.h"
#include "hooks/hookbeh/sub_behaviours.h"
#include "hooks/protocol/numbers.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/begun.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <utility>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;
using Reading = HookDepthReading;

TEST(HookbehHeadway, AMetreIsHeadway) {
  HookHeadway headway = begun(hookHeadwayInit);
  hookHeadwayObserve(&headway, HookWay::Down, 10, 4);
  EXPECT_EQ(headway.idle_s, 0);
  hookHeadwayObserve(&headway, HookWay::Down, 10.75, 4);
  EXPECT_EQ(headway.idle_s, 4);
  hookHeadwayObserve(&headway, HookWay::Down, 9, 4);
  EXPECT_EQ(headway.idle_s, 8) << "the wrong way";
  hookHeadwayObserve(&headway, HookWay::Down, 11, 4);
  EXPECT_EQ(headway.idle_s, 0);
  hookHeadwayObserve(&headway, HookWay::Down, 11.75, 4);
  EXPECT_EQ(headway.idle_s, 4) << "from the 11 m on";
}

TEST(HookbehHeadway, ADiveMayHaveStoppedAfterAMinuteOfItsOwn) {
  HookHeadway headway = begun(hookHeadwayInit);
  for (int s = 0; s <= 60; s += 4) {
    hookHeadwayObserve(&headway, HookWay::Down, 20, 4);
    EXPECT_EQ(hookHeadwayMayHaveStopped(&headway), s >= 60) << s;
  }
  hookHeadwayObserve(&headway, HookWay::None, 20, 4);
  hookHeadwayObserve(&headway, HookWay::Down, 20, 4);
  EXPECT_FALSE(hookHeadwayMayHaveStopped(&headway));
  for (int s = 4; s <= 180; s += 4) {
    hookHeadwayInterrupt(&headway);
    hookHeadwayObserve(&headway, HookWay::Down, 20, 4);
    EXPECT_FALSE(std::isfinite(hookHeadwayStandsAt(&headway)))
        << "a vehicle that turns stands for a while";
    EXPECT_EQ(hookHeadwayMayHaveStopped(&headway), s >= 180) << s;
  }
}

TEST(HookbehHeadway, AMetreLessIsHeadwayOfAClimb) {
  HookHeadway headway = begun(hookHeadwayInit);
  hookHeadwayObserve(&headway, HookWay::Up, 10, 4);
  hookHeadwayObserve(&headway, HookWay::Up, 9.25, 4);
  EXPECT_EQ(headway.idle_s, 4);
  hookHeadwayObserve(&headway, HookWay::Up, 9, 4);
  EXPECT_EQ(headway.idle_s, 0);
  hookHeadwayObserve(&headway, HookWay::Up, 8.5, 4);
  hookHeadwayObserve(&headway, HookWay::Down, 8.5, 4);
  EXPECT_EQ(headway.way, HookWay::Down);
  EXPECT_EQ(headway.idle_s, 0) << "it has only turned";
}

TEST(HookbehHeadway, BeginsWithoutADirection) {
  HookHeadway headway = begun(hookHeadwayInit);
  EXPECT_EQ(headway.way, HookWay::None);
  hookHeadwayObserve(&headway, HookWay::None, 0, 4);
  EXPECT_EQ(headway.idle_s, 4);
}

TEST(HookbehDepthSource, ReadsFromFiveMetresAboveTheSurfaceToHalfAsDeepAgainAsTheHull) {
  for (const double depth : {-5.0, 300.0}) {
    HookDepthSource source = begun(hookDepthSourceInit, &kHull);
    hookDepthSourceObserve(&source, depth, 4);
    EXPECT_EQ(source.reading, Reading::Good) << depth;
    EXPECT_EQ(source.depth_m, depth);
  }
  for (const double depth : {-5.25, 300.25, kNan}) {
    HookDepthSource source = begun(hookDepthSourceInit, &kHull);
    hookDepthSourceObserve(&source, depth, 4);
    EXPECT_EQ(source.reading, Reading::Missing) << depth;
    EXPECT_TRUE(std::isnan(source.depth_m));
  }
}

TEST(HookbehDepthSource, FollowsAsFarAsTheVehicleAndItsNoiseGo) {
  for (const double way : {1.0, -1.0}) {
    HookDepthSource source = begun(hookDepthSourceInit, &kHull);
    hookDepthSourceObserve(&source, 10, 4);
    hookDepthSourceObserve(&source, 10 + way * 3.5, 2.5);  // 2.5 m, and 1 m at 0.4 m/s
    EXPECT_EQ(source.reading, Reading::Good) << way;
    hookDepthSourceObserve(&source, 10 + way * 7.25, 2.5);
    EXPECT_EQ(source.reading, Reading::Jumped) << way;
  }
}

TEST(HookbehDepthSource, WhatWasMissingMayHaveChangedInTheMeantime) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  hookDepthSourceObserve(&source, 10, 4);
  hookDepthSourceObserve(&source, kNan, 4);
  hookDepthSourceObserve(&source, kNan, 6);
  EXPECT_EQ(source.age_s, 10);
  EXPECT_EQ(source.depth_m, 10);
  hookDepthSourceObserve(&source, 17.5, 2.5);  // 2.5 m, and 5 m in 12.5 s
  EXPECT_EQ(source.reading, Reading::Good);
  EXPECT_EQ(source.age_s, 0);
}

/// What has given 10 m for so many cycles of 4 s, and then jumped.
HookDepthSource jumpedAfter(int cycles) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  for (int i = 0; i < cycles; ++i) {
    hookDepthSourceObserve(&source, 10, 4);
  }
  hookDepthSourceObserve(&source, 50, 4);
  EXPECT_EQ(source.reading, Reading::Jumped);
  return source;
}

TEST(HookbehDepthSource, ItsFirstMinuteDoesNotCount) {
  EXPECT_EQ(jumpedAfter(14).depth_m, 50);
  EXPECT_EQ(jumpedAfter(14).age_s, 0);
  HookDepthSource nearly = begun(hookDepthSourceInit, &kHull);
  for (int i = 0; i < 119; ++i) {
    hookDepthSourceObserve(&nearly, 10, 0.5);
  }
  hookDepthSourceObserve(&nearly, 50, 0.5);
  EXPECT_EQ(nearly.depth_m, 50) << "59.5 s";
  EXPECT_EQ(jumpedAfter(15).depth_m, 10);
  EXPECT_EQ(jumpedAfter(15).age_s, 4);
}

TEST(HookbehDepthSource, GoodReadingsTakeAwayHalfOfTheirTime) {
  HookDepthSource source = jumpedAfter(20);
  EXPECT_EQ(source.jumped_s, 4);
  hookDepthSourceObserve(&source, 51, 4);
  EXPECT_EQ(source.jumped_s, 8);
  hookDepthSourceObserve(&source, 10, 4);
  EXPECT_EQ(source.jumped_s, 6);
  hookDepthSourceObserve(&source, 10, 20);
  EXPECT_EQ(source.jumped_s, 0) << "and no more";
}

TEST(HookbehDepthSource, CountsTheTimeOfEqualReadings) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(source.same_s, 0) << i;
    hookDepthSourceObserve(&source, 10 + i, 4);
  }
  hookDepthSourceObserve(&source, 13, 4);
  hookDepthSourceObserve(&source, kNan, 4);
  hookDepthSourceObserve(&source, 13, 2);
  EXPECT_EQ(source.same_s, 6) << "of what it said";
}

TEST(RecentDepths, HoldsTenForTwentySeconds) {
  HookRecentDepths recent = begun(hookRecentDepthsInit);
  hookRecentDepthsObserve(&recent, 10, 100);
  hookRecentDepthsObserve(&recent, 12, 12);
  hookRecentDepthsObserve(&recent, 13, 8);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 10), 0) << "20 s ago";
  hookRecentDepthsObserve(&recent, 13, 0.25);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 10), 2);
  for (int i = 0; i < 7; ++i) {
    hookRecentDepthsObserve(&recent, 13, 0.25);
  }
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 12), 0) << "one of ten";
  hookRecentDepthsObserve(&recent, 13, 0.25);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 12), 1) << "one of eleven";
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 15), 2);
}

VerticalCommand commandOf(HookHover& hover, const Surroundings& now, double step_s = 4) {
  VerticalCommand command;
  hookHoverCommand(&hover, &now, step_s, given(HookbehArgs{}), &command);
  return command;
}

/// One command of a hover at 20 m that begins so.
double firstPump(double depth_m, double rate_mps) {
  HookHover hover = begun(hookHoverInit, 20);
  const VerticalCommand command = commandOf(hover, {depth_m, rate_mps});
  EXPECT_EQ(command.pitch_rad, 0);
  return command.pump_cc;
}

TEST(HookbehHover, PumpsByDepthAndRate) {
  EXPECT_EQ(firstPump(20, 0), 0);
  EXPECT_EQ(firstPump(20.5, 0), 20) << "40 cc a metre";
  EXPECT_EQ(firstPump(19, 0.015625), -40 + 15.625) << "1000 cc for 1 m/s";
  EXPECT_EQ(firstPump(20.5, kNan), 20) << "without a rate by the depth alone";
  EXPECT_EQ(firstPump(26, 0), 230);
  EXPECT_EQ(firstPump(14, 0), -230);
  EXPECT_EQ(firstPump(kNan, 0), 230) << "out, where nothing is known";
}

TEST(HookbehHover, RestsUntilThePumpIsWantedFartherAway) {
  HookHover hover = begun(hookHoverInit, 20);
  EXPECT_EQ(commandOf(hover, {20, 0}).pump_cc, 0);
  EXPECT_EQ(commandOf(hover, {20.01, 0}).pump_cc, 0);
  EXPECT_GT(commandOf(hover, {23, 0}).pump_cc, 25);
}

TEST(HookbehHover, FollowsAMotionAndNotTheSwell) {
  HookHover sinks = begun(hookHoverInit, 20);
  HookHover swell = begun(hookHoverInit, 20);
  double pump = 0, strokes_cc = 0, before = 0;
  for (int i = 0; i < 100; ++i) {
    pump = commandOf(sinks, {20 + 0.05 * 4 * i, kNan}).pump_cc;
    if (i == 20) {
      EXPECT_NEAR(pump, 40 * 4.0 + 1000 * 0.05, 25 + 1) << "4 m too deep, at 5 cm/s";
    }
    // A period of 9 s.
    const double waves = commandOf(swell, {20 + 0.5 * __builtin_sin(0.7 * 4 * i), kNan}).pump_cc;
    strokes_cc += hookMagnitude(waves - before);
    before = waves;
  }
  EXPECT_EQ(pump, 230);
  EXPECT_LT(strokes_cc, 466) << "not a stroke in 400 s";
}

TEST(HookbehHover, TakesNoReadingTwiceAndWaitsWhileItIsMasked) {
  HookHover hover = begun(hookHoverInit, 20);
  for (const double depth_m : {20.0, 20.8, 21.6}) {  // 0.05 m/s, a reading every 16 s
    commandOf(hover, {depth_m, kNan});
    for (int i = 0; i < 3; ++i) {
      commandOf(hover, {depth_m, kNan});
    }
  }
  EXPECT_NEAR(commandOf(hover, {22.4, kNan}).pump_cc, 40 * 2.4 + 1000 * 0.05, 26);
  const double kept = commandOf(hover, {22.4, kNan}, 0).pump_cc;
  EXPECT_EQ(commandOf(hover, {22.5, kNan}, 0).pump_cc, kept);
}

TEST(HookbehUsualPitch, LiesInTheBArgs) {
  HookbehArgs args;
  EXPECT_EQ(hookUsualPitch(&args), 0.4538);
  args.steepest_pitch_rad = 0.25;
  EXPECT_EQ(hookUsualPitch(&args), 0.25);
  args.steepest_pitch_rad = 0.7;
  args.shallowest_pitch_rad = 0.5;
  EXPECT_EQ(hookUsualPitch(&args), 0.5);
}

/// A pilot under one instruction, with the depth the test gives.
struct PilotBench {
  explicit PilotBench(const Instruction& instruction, HookbehArgs with = {}) : args(with) {
    hookPilotBegin(&pilot, &instruction);
  }
  VerticalCommand at(double depth_m, double step_s = 4) {
    VerticalCommand command;
    hookPilotVertical(&pilot, given(Surroundings{depth_m}), step_s, &args, &command);
    return command;
  }
  const char* goBackFrom(double depth_m, bool checked = false) {
    hookPilotGoBack(&pilot, given(Surroundings{depth_m}), &args, checked);
    return wordsFor(at(depth_m).doing);
  }
  HookLateralCommand lateral(const Surroundings& now = {}) {
    HookLateralCommand command;
    hookPilotLateral(&pilot, &now, &command);
    return command;
  }
  HookbehArgs args;
  HookPilot pilot = begun(hookPilotInit);
};

TEST(HookbehPilot, WithinTwoMetresItHovers) {
  for (const double depth : {18.0, 20.0, 22.0}) {
    EXPECT_STREQ(wordsFor(PilotBench(Bench::vertical(HookVertical::Hover, 20)).at(depth).doing),
                 "hover");
  }
  EXPECT_STREQ(wordsFor(PilotBench(Bench::vertical(HookVertical::Hover, 20)).at(17.75).doing),
               "dive_to");
  PilotBench above(Bench::vertical(HookVertical::Hover, 20));
  EXPECT_STREQ(wordsFor(above.at(22.25).doing), "climb_to");
  EXPECT_EQ(above.at(22.25).pitch_rad, 0.4538);
  EXPECT_EQ(hookPilotWay(&above.pilot, 22.25), HookWay::Up);
  EXPECT_STREQ(wordsFor(above.at(22).doing), "hover")
      << "no climb was commanded that might be held";
}

TEST(HookbehPilot, AGuardsClimbOfMoreThanTwoMetresIsGoneBackFrom) {
  for (const double depth : {18.0, 22.0}) {
    PilotBench bench(Bench::vertical(HookVertical::Hover, 20));
    bench.at(20);
    EXPECT_STREQ(bench.goBackFrom(depth), "hover") << depth;
  }
  PilotBench below(Bench::vertical(HookVertical::Hover, 20));
  below.at(20);
  EXPECT_STREQ(below.goBackFrom(22.25), "climb_to");
  PilotBench above(Bench::vertical(HookVertical::Hover, 20));
  above.at(20);
  EXPECT_STREQ(above.goBackFrom(17.75), "dive_to");
}

TEST(HookbehPilot, ACheckOfTheDepthIsGoneBackFromByThePumpWithinSixMetres) {
  for (const auto& [depth, doing] :
       {std::pair{14.0, "hover"}, {26.0, "hover"}, {13.75, "dive_to"}, {26.25, "climb_to"}}) {
    PilotBench bench(Bench::vertical(HookVertical::Hover, 20));
    bench.at(20);
    EXPECT_STREQ(bench.goBackFrom(depth, true), doing) << depth;
  }
  PilotBench holds(Bench::ascend(20));
  EXPECT_STREQ(wordsFor(holds.at(20).doing), "hold");
  EXPECT_STREQ(holds.goBackFrom(17.75, true), "dive_to") << "it does not hover yet";
}

TEST(HookbehPilot, WithinTwoMetresItHoldsOn) {
  for (const auto& [depth, doing] :
       {std::pair{18.0, "hold"}, {22.0, "hold"}, {17.75, "dive_to"}, {22.25, "climb_to"}}) {
    PilotBench bench(Bench::ascend(20));
    EXPECT_STREQ(wordsFor(bench.at(20).doing), "hold");
    EXPECT_STREQ(bench.goBackFrom(depth), doing) << depth;
  }
}

TEST(HookbehPilot, AnAscendThatHadArrivedClimbsAgainAsInstructed) {
  PilotBench bench(Bench::ascend(20));
  EXPECT_STREQ(wordsFor(bench.at(20).doing), "hold");
  EXPECT_STREQ(bench.goBackFrom(22.25), "climb_to");
  EXPECT_EQ(bench.at(22.25).pitch_rad, 0.4) << "no usual pitch";
  EXPECT_STREQ(wordsFor(bench.at(20).doing), "hold");
}

TEST(HookbehPilot, WhatHasNotArrivedGoesOnAsItDid) {
  PilotBench bench(Bench::descend(20));
  EXPECT_STREQ(wordsFor(bench.at(10).doing), "dive_to");
  EXPECT_STREQ(bench.goBackFrom(5), "dive_to");
  EXPECT_EQ(bench.at(5).pitch_rad, -0.4);
  PilotBench climbing(Bench::vertical(HookVertical::Hover, 20));
  EXPECT_STREQ(wordsFor(climbing.at(30).doing), "climb_to");
  EXPECT_STREQ(climbing.goBackFrom(10), "hover") << "its climb is over";
}

TEST(HookbehPilot, HoldsForItsTimeWhereItArrived) {
  PilotBench bench(Bench::descend(20));
  const VerticalCommand dive = bench.at(19);
  for (int i = 0; i < 3; ++i) {
    const VerticalCommand hold = bench.at(20 + 0.5 * i);
    EXPECT_STREQ(wordsFor(hold.doing), "hold") << i;
    EXPECT_EQ(hold.pitch_rad, dive.pitch_rad);
    EXPECT_EQ(hold.pump_cc, dive.pump_cc);
    EXPECT_EQ(hookPilotWay(&bench.pilot, 21), HookWay::None);
  }
  EXPECT_STREQ(wordsFor(bench.at(21).doing), "hover") << "12 s";
  PilotBench nearly(Bench::descend(20));
  EXPECT_STREQ(wordsFor(nearly.at(20).doing), "hold");
  for (int i = 0; i < 3; ++i) {
    EXPECT_STREQ(wordsFor(nearly.at(20, 3.75).doing), "hold") << "0.75 s are left at last";
  }
  EXPECT_STREQ(wordsFor(nearly.at(20, 3.75).doing), "hover");
}

TEST(HookbehPilot, HoldsNothingAMetreBeyondTheTargetOrInNoTime) {
  EXPECT_STREQ(wordsFor(PilotBench(Bench::descend(20)).at(21).doing), "hold");
  EXPECT_STREQ(wordsFor(PilotBench(Bench::descend(20)).at(21.25).doing), "hover");
  PilotBench bench(Bench::descend(20));
  EXPECT_STREQ(wordsFor(bench.at(20).doing), "hold");
  EXPECT_STREQ(wordsFor(bench.at(21.25).doing), "hover");
  HookbehArgs args;
  args.hold_secs = 0;
  EXPECT_STREQ(wordsFor(PilotBench(Bench::descend(20), args).at(20).doing), "hover");
  args.hold_secs = 0.5;
  EXPECT_STREQ(wordsFor(PilotBench(Bench::descend(20), args).at(20).doing), "hold");
  PilotBench climbed(Bench::ascend(20));
  EXPECT_STREQ(wordsFor(climbed.at(15).doing), "hold");
  EXPECT_STREQ(wordsFor(climbed.at(21.5).doing), "hold") << "a climb is not a dive";
}

TEST(HookbehPilot, ShallowerThanAMetreHoveringIsFloating) {
  EXPECT_STREQ(wordsFor(PilotBench(Bench::vertical(HookVertical::Hover, 1)).at(1).doing), "hover");
  PilotBench bench(Bench::vertical(HookVertical::Hover, 0.75));
  EXPECT_STREQ(wordsFor(bench.at(1).doing), "surface");
  EXPECT_EQ(hookPilotWay(&bench.pilot, 3), HookWay::None);
  EXPECT_EQ(hookPilotWay(&bench.pilot, 3.25), HookWay::Up);
}

TEST(HookbehPilot, AHoverDrivesWhereItIsSixMetresOff) {
  PilotBench bench(Bench::vertical(HookVertical::Hover, 20));
  bench.at(20);
  EXPECT_EQ(hookPilotWay(&bench.pilot, 14), HookWay::None);
  EXPECT_EQ(hookPilotWay(&bench.pilot, 26), HookWay::None);
  EXPECT_EQ(hookPilotWay(&bench.pilot, 13.75), HookWay::Down);
  EXPECT_EQ(hookPilotWay(&bench.pilot, 26.25), HookWay::Up);
  EXPECT_EQ(hookPilotWay(given(PilotBench(Bench::descend(20)).pilot), 0), HookWay::None)
      << "not before it has chosen";
}

TEST(HookbehPilot, ANewInstructionIsChosenOnlyWhereItsVerticalPartIsAnother) {
  PilotBench bench(Bench::descend(20));
  EXPECT_STREQ(wordsFor(bench.at(20).doing), "hold");
  hookPilotFollow(&bench.pilot, given(Bench::descend(20)));
  EXPECT_STREQ(wordsFor(bench.at(19).doing), "hold") << "the same";
  Instruction none = Bench::vertical(HookVertical::None);
  none.pitch_rad = 0;
  hookPilotFollow(&bench.pilot, &none);
  EXPECT_STREQ(wordsFor(bench.at(19).doing), "hold") << "none";
  EXPECT_EQ(bench.pilot.in_force.vertical, HookVertical::Descend);
  EXPECT_EQ(bench.pilot.in_force.depth_m, 20);
  EXPECT_EQ(bench.pilot.in_force.pitch_rad, -0.4);
  hookPilotFollow(&bench.pilot, given(Bench::descend(20.5)));
  EXPECT_STREQ(wordsFor(bench.at(19).doing), "dive_to") << "deeper";
  EXPECT_STREQ(wordsFor(bench.at(20.5).doing), "hold");
  Instruction steeper = Bench::descend(20.5);
  steeper.pitch_rad = -0.5;
  hookPilotFollow(&bench.pilot, &steeper);
  EXPECT_EQ(bench.at(19).pitch_rad, -0.5) << "steeper";
  EXPECT_EQ(bench.at(10).pitch_rad, -0.5);
  Instruction hover = steeper;
  hover.vertical = HookVertical::Hover;
  hookPilotFollow(&bench.pilot, &hover);
  EXPECT_EQ(bench.at(10).pitch_rad, -0.4538) << "a hover";
}

TEST(HookbehPilot, LateralCommandsAtTheirEdges) {
  Instruction instruction = Bench::descend(20);
  instruction.lateral = HookLateral::Heading;
  const auto heading = [&](double rad) {
    instruction.heading_rad = rad;
    const HookLateralCommand command = PilotBench(instruction).lateral();
    EXPECT_EQ(command.mode, HeadingMode::Heading);
    return command.heading_rad;
  };
  EXPECT_EQ(heading(0), 0);
  EXPECT_EQ(heading(1.5), 1.5);
  EXPECT_EQ(heading(-0.25), 6.283185307179586 - 0.25);
  instruction.lateral = HookLateral::Waypoint;
  instruction.latitude_ddmm = 3910;
  instruction.longitude_ddmm = -7350;
  Surroundings now;
  const HookLateralCommand there = PilotBench(instruction).lateral(now);
  EXPECT_EQ(there.mode, HeadingMode::Waypoint);
  EXPECT_EQ(there.heading_rad, 0);
  EXPECT_EQ(there.latitude_ddmm, 3910);
  EXPECT_EQ(there.longitude_ddmm, -7350);
  now.longitude_ddmm = kNan;
  EXPECT_EQ(PilotBench(instruction).lateral(now).mode, HeadingMode::CentreFin);
  now = {};
  now.latitude_ddmm = kNan;
  EXPECT_EQ(PilotBench(instruction).lateral(now).mode, HeadingMode::CentreFin);
  instruction.lateral = HookLateral::Fin;
  instruction.heading_rad = -0.25;
  const HookLateralCommand held = PilotBench(instruction).lateral(now);
  EXPECT_EQ(held.mode, HeadingMode::Fin);
  EXPECT_EQ(held.fin_rad, -0.25) << "no heading: nothing is added";
  instruction.lateral = HookLateral::Drift;
  EXPECT_EQ(PilotBench(instruction).lateral().mode, HeadingMode::CentreFin);
}

}  // namespace
}  // namespace glider::hooks
