// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The guard's limits in time, in cycles of a second, and those of a vehicle that may sink unseen.

#include "hooks/hookbeh/guard.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/begun.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

constexpr VerticalCommand kOtherSub{0, kNan}, kAdrift{0, 0}, kSteep{-0.7854, -230},
    kFlat{-0.1, -230};
constexpr double kSteepMps = 1.1 * 0.4;
constexpr double kFlatMps = kSteepMps * 0.3 / 0.7854;

/// A guard whose vehicle has a depth, and perhaps a CTD, that flicker and do not move.
struct StillVehicle {
  explicit StillVehicle(double depth_m) : depth(depth_m) {}

  HookGuard cycle(double step_s = 1) {
    flicker = -flicker;
    hookbehGuardObserve(&guard, &args, given(Surroundings{depth + flicker, 0, kNan, ctd + flicker}),
                        step_s, &last, way);
    return hookbehGuardMustClimb(&guard, &args, &in_force);
  }
  HookGuard run(int cycles) {
    HookGuard found = HookGuard::None;
    for (int i = 0; i < cycles; ++i) {
      found = cycle();
    }
    return found;
  }
  bool shows(double step_s = 1) {
    cycle(step_s);
    return hookbehGuardMustShowDepth(&guard, &args, &in_force);
  }
  /// Cycles until there is this guard, or none; at most 1000.
  int until(HookGuard wanted) {
    int cycles = 1;
    while (cycle() != wanted && cycles < 1000) {
      ++cycles;
    }
    return cycles;
  }

  HookbehGuard guard = begun(hookbehGuardInit, &kHull);
  HookbehArgs args;
  Instruction in_force = Bench::vertical(HookVertical::Hover, 10);
  VerticalCommand last = kOtherSub;
  HookWay way = HookWay::None;
  double depth, ctd = kNan, flicker = 1.0 / 1024;
};

TEST(GuardSinkEdges, ADiveHas180SecondsForAMetreAndAClimb240) {
  for (const bool up : {false, true}) {
    StillVehicle vehicle(10);
    vehicle.way = up ? HookWay::Up : HookWay::Down;
    EXPECT_EQ(vehicle.run(up ? 240 : 180), HookGuard::None);
    EXPECT_EQ(vehicle.cycle(), up ? HookGuard::NoHeightGained : HookGuard::NoDepthGained);
  }
}

/// A dive at the surface has gained no depth.
StillVehicle idle() {
  StillVehicle vehicle(0.5);
  vehicle.way = HookWay::Down;
  EXPECT_EQ(vehicle.run(181), HookGuard::NoDepthGained);
  vehicle.way = HookWay::None;
  return vehicle;
}

TEST(GuardSinkEdges, ADiveIsTriedAgainAfter600SecondsOfWhichTheDepthLivedFor60) {
  EXPECT_EQ(idle().until(HookGuard::None), 600);
  StillVehicle vehicle = idle();
  vehicle.run(580);
  vehicle.depth = kNan;
  vehicle.cycle();
  vehicle.depth = 0.5;
  EXPECT_EQ(vehicle.until(HookGuard::None), 60);
}

TEST(GuardSinkEdges, ANewSessionForgetsALimitButNotThatNoDepthWasGained) {
  StillVehicle vehicle(30.5);
  EXPECT_EQ(vehicle.cycle(), HookGuard::TooDeep);
  vehicle.depth = 29.5;
  EXPECT_EQ(vehicle.cycle(), HookGuard::TooDeep);
  hookbehGuardReset(&vehicle.guard);
  EXPECT_EQ(vehicle.cycle(), HookGuard::None);
  StillVehicle other = idle();
  hookbehGuardReset(&other.guard);
  EXPECT_EQ(other.cycle(), HookGuard::NoDepthGained);
}

TEST(GuardSinkEdges, BeforeItHasMovedTwentyMetresAreAllThatItMaySink) {
  StillVehicle vehicle(20);
  vehicle.args.greatest_depth_m = 200;
  vehicle.shows(10);
  vehicle.last = kAdrift;
  vehicle.shows(10);  // it may rise for 12 s
  for (int metres = 1; metres < 20; ++metres) {
    ASSERT_FALSE(vehicle.shows(10)) << metres;
  }
  EXPECT_TRUE(vehicle.shows(10));
}

/// Metres to the surface from which a dive of one cycle is counted, where the CTD sees the
/// vehicle.
bool diveEnds(double greatest_m, double depth_m, double dive_m) {
  StillVehicle vehicle(depth_m);
  vehicle.args.greatest_depth_m = greatest_m;
  vehicle.ctd = depth_m;
  vehicle.way = HookWay::Down;
  vehicle.cycle();
  vehicle.last = kSteep;
  const double step_s = dive_m / kSteepMps;
  EXPECT_EQ(kSteepMps * step_s, dive_m) << "exactly";
  return vehicle.shows(step_s);
}

TEST(GuardSinkEdges, WithAnyCtdADiveEndsPastTheLimitByAShareOfIt) {
  EXPECT_TRUE(diveEnds(8, 7.5, 11)) << "11 m at least";
  EXPECT_FALSE(diveEnds(8, 7.5, 10.875));
  EXPECT_TRUE(diveEnds(50, 22, 50.0625)) << "0.44 of 50 m past 50 m";
  EXPECT_FALSE(diveEnds(50, 22, 49.9375));
  EXPECT_TRUE(diveEnds(kNan, 22, 11)) << "a limit that is none: the least";
}

/// The same, without a CTD and nearly level: so many seconds.
bool levelDiveEnds(double greatest_m, double depth_m, double seconds) {
  StillVehicle vehicle(depth_m);
  vehicle.args.greatest_depth_m = greatest_m;
  vehicle.cycle();
  vehicle.last = kFlat;
  EXPECT_LT(kFlatMps * seconds, greatest_m - depth_m) << "it is not there by its own pitch";
  return vehicle.shows(seconds);
}

TEST(GuardSinkEdges, WithoutACtdItEndsWhereItMayBeAtTheSteepestPitch) {
  const double least_s = 18 / kSteepMps;
  EXPECT_EQ(kSteepMps * least_s, 18) << "exactly";
  EXPECT_TRUE(levelDiveEnds(12, 4, least_s)) << "18 m at least";
  EXPECT_FALSE(levelDiveEnds(12, 4, least_s - 0.25));
  EXPECT_TRUE(levelDiveEnds(30, 10, 33.25 / kSteepMps)) << "20 m, and 0.44 of 30 m";
  EXPECT_FALSE(levelDiveEnds(30, 10, 33.125 / kSteepMps));
}

TEST(GuardSinkEdges, ALimitThatIsNoneLeavesTheLeastOfASteepDive) {
  StillVehicle vehicle(10);
  vehicle.args.greatest_depth_m = kNan;
  vehicle.cycle();
  vehicle.last = kFlat;
  EXPECT_TRUE(vehicle.shows(18 / kSteepMps));
}

TEST(GuardSinkEdges, ItShowsItsDepthUntilItMayBeBackAtTheOneItShowed) {
  StillVehicle vehicle(20);
  vehicle.cycle();
  vehicle.last = kAdrift;
  EXPECT_TRUE(vehicle.shows(101)) << "10 m";
  EXPECT_TRUE(vehicle.shows());
  vehicle.ctd = 20;
  EXPECT_FALSE(vehicle.shows()) << "the CTD sees it there";
}

}  // namespace
}  // namespace glider::hooks
