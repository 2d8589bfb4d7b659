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
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <utility>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;
using Reading = DepthSource::Reading;

TEST(HookbehHeadway, AMetreIsHeadway) {
  Headway headway;
  headway.observe(Way::Down, 10, 4);
  EXPECT_EQ(headway.idleFor(), 0);
  headway.observe(Way::Down, 10.75, 4);
  EXPECT_EQ(headway.idleFor(), 4);
  headway.observe(Way::Down, 9, 4);
  EXPECT_EQ(headway.idleFor(), 8) << "the wrong way";
  headway.observe(Way::Down, 11, 4);
  EXPECT_EQ(headway.idleFor(), 0);
  headway.observe(Way::Down, 11.75, 4);
  EXPECT_EQ(headway.idleFor(), 4) << "from the 11 m on";
}

TEST(HookbehHeadway, ADiveMayHaveStoppedAfterAMinuteOfItsOwn) {
  Headway headway;
  for (int s = 0; s <= 60; s += 4) {
    headway.observe(Way::Down, 20, 4);
    EXPECT_EQ(headway.mayHaveStopped(), s >= 60) << s;
  }
  headway.observe(Way::None, 20, 4);
  headway.observe(Way::Down, 20, 4);
  EXPECT_FALSE(headway.mayHaveStopped());
  for (int s = 4; s <= 180; s += 4) {
    headway.interrupt();
    headway.observe(Way::Down, 20, 4);
    EXPECT_FALSE(headway.standsInDive()) << "a vehicle that turns stands for a while";
    EXPECT_EQ(headway.mayHaveStopped(), s >= 180) << s;
  }
}

TEST(HookbehHeadway, AMetreLessIsHeadwayOfAClimb) {
  Headway headway;
  headway.observe(Way::Up, 10, 4);
  headway.observe(Way::Up, 9.25, 4);
  EXPECT_EQ(headway.idleFor(), 4);
  headway.observe(Way::Up, 9, 4);
  EXPECT_EQ(headway.idleFor(), 0);
  headway.observe(Way::Up, 8.5, 4);
  headway.observe(Way::Down, 8.5, 4);
  EXPECT_EQ(headway.way(), Way::Down);
  EXPECT_EQ(headway.idleFor(), 0) << "it has only turned";
}

TEST(HookbehHeadway, BeginsWithoutADirection) {
  Headway headway;
  EXPECT_EQ(headway.way(), Way::None);
  headway.observe(Way::None, 0, 4);
  EXPECT_EQ(headway.idleFor(), 4);
}

TEST(HookbehDepthSource, ReadsFromFiveMetresAboveTheSurfaceToHalfAsDeepAgainAsTheHull) {
  for (const double depth : {-5.0, 300.0}) {
    DepthSource source{kHull};
    source.observe(depth, 4);
    EXPECT_EQ(source.reading(), Reading::Good) << depth;
    EXPECT_EQ(source.depth(), depth);
  }
  for (const double depth : {-5.25, 300.25, kNan}) {
    DepthSource source{kHull};
    source.observe(depth, 4);
    EXPECT_EQ(source.reading(), Reading::Missing) << depth;
    EXPECT_TRUE(std::isnan(source.depth()));
  }
}

TEST(HookbehDepthSource, FollowsAsFarAsTheVehicleAndItsNoiseGo) {
  for (const double way : {1.0, -1.0}) {
    DepthSource source{kHull};
    source.observe(10, 4);
    source.observe(10 + way * 3.5, 2.5);  // 2.5 m, and 1 m at 0.4 m/s
    EXPECT_EQ(source.reading(), Reading::Good) << way;
    source.observe(10 + way * 7.25, 2.5);
    EXPECT_EQ(source.reading(), Reading::Jumped) << way;
  }
}

TEST(HookbehDepthSource, WhatWasMissingMayHaveChangedInTheMeantime) {
  DepthSource source{kHull};
  source.observe(10, 4);
  source.observe(kNan, 4);
  source.observe(kNan, 6);
  EXPECT_EQ(source.age(), 10);
  EXPECT_EQ(source.depth(), 10);
  source.observe(17.5, 2.5);  // 2.5 m, and 5 m in 12.5 s
  EXPECT_EQ(source.reading(), Reading::Good);
  EXPECT_EQ(source.age(), 0);
}

/// What has given 10 m for so many cycles of 4 s, and then jumped.
DepthSource jumpedAfter(int cycles) {
  DepthSource source{kHull};
  for (int i = 0; i < cycles; ++i) {
    source.observe(10, 4);
  }
  source.observe(50, 4);
  EXPECT_EQ(source.reading(), Reading::Jumped);
  return source;
}

TEST(HookbehDepthSource, ItsFirstMinuteDoesNotCount) {
  EXPECT_EQ(jumpedAfter(14).depth(), 50);
  EXPECT_EQ(jumpedAfter(14).age(), 0);
  DepthSource nearly{kHull};
  for (int i = 0; i < 119; ++i) {
    nearly.observe(10, 0.5);
  }
  nearly.observe(50, 0.5);
  EXPECT_EQ(nearly.depth(), 50) << "59.5 s";
  EXPECT_EQ(jumpedAfter(15).depth(), 10);
  EXPECT_EQ(jumpedAfter(15).age(), 4);
}

TEST(HookbehDepthSource, GoodReadingsTakeAwayHalfOfTheirTime) {
  DepthSource source = jumpedAfter(20);
  EXPECT_EQ(source.jumpedFor(), 4);
  source.observe(51, 4);
  EXPECT_EQ(source.jumpedFor(), 8);
  source.observe(10, 4);
  EXPECT_EQ(source.jumpedFor(), 6);
  source.observe(10, 20);
  EXPECT_EQ(source.jumpedFor(), 0) << "and no more";
}

TEST(HookbehDepthSource, CountsTheTimeOfEqualReadings) {
  DepthSource source{kHull};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(source.sameFor(), 0) << i;
    source.observe(10 + i, 4);
  }
  source.observe(13, 4);
  source.observe(kNan, 4);
  source.observe(13, 2);
  EXPECT_EQ(source.sameFor(), 6) << "of what it said";
}

TEST(RecentDepths, HoldsTenForTwentySeconds) {
  RecentDepths recent;
  recent.observe(10, 100);
  recent.observe(12, 12);
  recent.observe(13, 8);
  EXPECT_EQ(recent.distanceTo(10), 0) << "20 s ago";
  recent.observe(13, 0.25);
  EXPECT_EQ(recent.distanceTo(10), 2);
  for (int i = 0; i < 7; ++i) {
    recent.observe(13, 0.25);
  }
  EXPECT_EQ(recent.distanceTo(12), 0) << "one of ten";
  recent.observe(13, 0.25);
  EXPECT_EQ(recent.distanceTo(12), 1) << "one of eleven";
  EXPECT_EQ(recent.distanceTo(15), 2);
}

/// One command of a hover at 20 m that begins so.
double firstPump(double depth_m, double rate_mps) {
  Hover hover(20);
  const VerticalCommand command = hover.command({depth_m, rate_mps}, 4, HookbehArgs{});
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
  const HookbehArgs args;
  Hover hover(20);
  EXPECT_EQ(hover.command({20, 0}, 4, args).pump_cc, 0);
  EXPECT_EQ(hover.command({20.01, 0}, 4, args).pump_cc, 0);
  EXPECT_GT(hover.command({23, 0}, 4, args).pump_cc, 25);
}

TEST(HookbehHover, FollowsAMotionAndNotTheSwell) {
  const HookbehArgs args;
  Hover sinks(20), swell(20);
  double pump = 0, strokes_cc = 0, before = 0;
  for (int i = 0; i < 100; ++i) {
    pump = sinks.command({20 + 0.05 * 4 * i, kNan}, 4, args).pump_cc;
    if (i == 20) {
      EXPECT_NEAR(pump, 40 * 4.0 + 1000 * 0.05, 25 + 1) << "4 m too deep, at 5 cm/s";
    }
    // A period of 9 s.
    const double waves =
        swell.command({20 + 0.5 * __builtin_sin(0.7 * 4 * i), kNan}, 4, args).pump_cc;
    strokes_cc += magnitude(waves - before);
    before = waves;
  }
  EXPECT_EQ(pump, 230);
  EXPECT_LT(strokes_cc, 466) << "not a stroke in 400 s";
}

TEST(HookbehHover, TakesNoReadingTwiceAndWaitsWhileItIsMasked) {
  const HookbehArgs args;
  Hover hover(20);
  for (const double depth_m : {20.0, 20.8, 21.6}) {  // 0.05 m/s, a reading every 16 s
    (void)hover.command({depth_m, kNan}, 4, args);
    for (int i = 0; i < 3; ++i) {
      (void)hover.command({depth_m, kNan}, 4, args);
    }
  }
  EXPECT_NEAR(hover.command({22.4, kNan}, 4, args).pump_cc, 40 * 2.4 + 1000 * 0.05, 26);
  const double kept = hover.command({22.4, kNan}, 0, args).pump_cc;
  EXPECT_EQ(hover.command({22.5, kNan}, 0, args).pump_cc, kept);
}

TEST(HookbehUsualPitch, LiesInTheBArgs) {
  HookbehArgs args;
  EXPECT_EQ(usualPitch(args), 0.4538);
  args.steepest_pitch_rad = 0.25;
  EXPECT_EQ(usualPitch(args), 0.25);
  args.steepest_pitch_rad = 0.7;
  args.shallowest_pitch_rad = 0.5;
  EXPECT_EQ(usualPitch(args), 0.5);
}

/// A pilot under one instruction, with the depth the test gives.
struct PilotBench {
  explicit PilotBench(const Instruction& instruction, HookbehArgs with = {}) : args(with) {
    pilot.begin(instruction);
  }
  VerticalCommand at(double depth_m, double step_s = 4) {
    return pilot.vertical({depth_m}, step_s, args);
  }
  const char* goBackFrom(double depth_m, bool checked = false) {
    pilot.goBack({depth_m}, args, checked);
    return wordsFor(at(depth_m).doing);
  }
  HookbehArgs args;
  Pilot pilot;
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
  EXPECT_EQ(above.pilot.way(22.25), Way::Up);
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
    EXPECT_EQ(bench.pilot.way(21), Way::None);
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
  EXPECT_EQ(bench.pilot.way(3), Way::None);
  EXPECT_EQ(bench.pilot.way(3.25), Way::Up);
}

TEST(HookbehPilot, AHoverDrivesWhereItIsSixMetresOff) {
  PilotBench bench(Bench::vertical(HookVertical::Hover, 20));
  bench.at(20);
  EXPECT_EQ(bench.pilot.way(14), Way::None);
  EXPECT_EQ(bench.pilot.way(26), Way::None);
  EXPECT_EQ(bench.pilot.way(13.75), Way::Down);
  EXPECT_EQ(bench.pilot.way(26.25), Way::Up);
  EXPECT_EQ(PilotBench(Bench::descend(20)).pilot.way(0), Way::None) << "not before it has chosen";
}

TEST(HookbehPilot, ANewInstructionIsChosenOnlyWhereItsVerticalPartIsAnother) {
  PilotBench bench(Bench::descend(20));
  EXPECT_STREQ(wordsFor(bench.at(20).doing), "hold");
  bench.pilot.follow(Bench::descend(20));
  EXPECT_STREQ(wordsFor(bench.at(19).doing), "hold") << "the same";
  Instruction none = Bench::vertical(HookVertical::None);
  none.pitch_rad = 0;
  bench.pilot.follow(none);
  EXPECT_STREQ(wordsFor(bench.at(19).doing), "hold") << "none";
  EXPECT_EQ(bench.pilot.inForce().vertical, HookVertical::Descend);
  EXPECT_EQ(bench.pilot.inForce().depth_m, 20);
  EXPECT_EQ(bench.pilot.inForce().pitch_rad, -0.4);
  bench.pilot.follow(Bench::descend(20.5));
  EXPECT_STREQ(wordsFor(bench.at(19).doing), "dive_to") << "deeper";
  EXPECT_STREQ(wordsFor(bench.at(20.5).doing), "hold");
  Instruction steeper = Bench::descend(20.5);
  steeper.pitch_rad = -0.5;
  bench.pilot.follow(steeper);
  EXPECT_EQ(bench.at(19).pitch_rad, -0.5) << "steeper";
  EXPECT_EQ(bench.at(10).pitch_rad, -0.5);
  Instruction hover = steeper;
  hover.vertical = HookVertical::Hover;
  bench.pilot.follow(hover);
  EXPECT_EQ(bench.at(10).pitch_rad, -0.4538) << "a hover";
}

TEST(HookbehPilot, LateralCommandsAtTheirEdges) {
  Instruction instruction = Bench::descend(20);
  instruction.lateral = HookLateral::Heading;
  const auto heading = [&](double rad) {
    instruction.heading_rad = rad;
    const LateralCommand command = PilotBench(instruction).pilot.lateral({});
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
  const LateralCommand there = PilotBench(instruction).pilot.lateral(now);
  EXPECT_EQ(there.mode, HeadingMode::Waypoint);
  EXPECT_EQ(there.heading_rad, 0);
  EXPECT_EQ(there.latitude_ddmm, 3910);
  EXPECT_EQ(there.longitude_ddmm, -7350);
  now.longitude_ddmm = kNan;
  EXPECT_EQ(PilotBench(instruction).pilot.lateral(now).mode, HeadingMode::CentreFin);
  now = {};
  now.latitude_ddmm = kNan;
  EXPECT_EQ(PilotBench(instruction).pilot.lateral(now).mode, HeadingMode::CentreFin);
  instruction.lateral = HookLateral::Fin;
  instruction.heading_rad = -0.25;
  const LateralCommand held = PilotBench(instruction).pilot.lateral(now);
  EXPECT_EQ(held.mode, HeadingMode::Fin);
  EXPECT_EQ(held.fin_rad, -0.25) << "no heading: nothing is added";
  instruction.lateral = HookLateral::Drift;
  EXPECT_EQ(PilotBench(instruction).pilot.lateral({}).mode, HeadingMode::CentreFin);
}

}  // namespace
}  // namespace glider::hooks
