// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A guard ends when its reason has passed: what was wrong once must not cost the mission.

#include "tests/unit/hooks/hookbeh_sea.h"
#include "tests/unit/hooks/hookbeh_shallow_sea.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::hooks {
namespace {

double deepWater(double) {
  return 500;
}

/// A healthy altimeter of 36 m, in each cycle.
double hears(double height) {
  return height <= 36 ? height : kNan;
}

double deepestIn(ShallowSea& sea, double hours) {
  sea.deepest = 0;
  sea.yo(hours);
  return sea.deepest;
}

HookbehArgs above(double least_altitude_m) {
  HookbehArgs args = ShallowSea::wide();
  args.least_altitude_m = least_altitude_m;
  return args;
}

TEST(HookbehRelease, AfterADiveOverABankTheVehicleDivesInDeeperWater) {
  for (const double bank : {8.0, 9.5, 11.0}) {
    for (const double beyond : {30.0, 45.0}) {
      ShallowSea sea;
      sea.bottom = [&](double north) { return north < 60 ? bank : beyond; };
      sea.altitude = hears;
      sea.yo(1);
      EXPECT_GT(deepestIn(sea, 2), beyond - 8) << bank;
      EXPECT_EQ(sea.touches, 0) << bank;
    }
  }
}

TEST(HookbehRelease, OneFalseEchoDoesNotKeepTheVehicleUpWhateverItsLeastAltitude) {
  for (const double least : {2.0, 5.0, 10.0, 15.0, 30.0}) {
    for (const double false_bottom : {13.0, 19.5, 30.0, 40.0}) {
      ShallowSea sea(above(least));
      sea.bottom = deepWater;
      bool heard = false;
      sea.altitude = [&](double) {
        const bool now = !heard && sea.truth > 6;
        heard = heard || now;
        return now ? false_bottom - sea.truth : kNan;
      };
      sea.yo(2);
      EXPECT_GT(deepestIn(sea, 1), 54) << least << " over " << false_bottom;
    }
  }
}

TEST(HookbehRelease, AnEchoFromBeforeItBeganIsNone) {
  for (const double old : {3.0, 15.0, 20.0}) {
    HookbehBench bench(ShallowSea::wide());
    bench.inputs.altitude_m = old;
    bench.inputs.depth_m = 0.5;
    bench.cycle();
    EXPECT_EQ(bench.give(HookbehBench::take(50)).guard, HookGuard::None) << old;
    for (double depth = 1; depth < 49; depth += 0.8) {
      bench.inputs.depth_m = depth;
      ASSERT_EQ(bench.cycle().guard, HookGuard::None) << old << " at " << depth;
    }
  }
}

TEST(HookbehRelease, AnEchoThatCameWithoutADepthIsNotAddedToALaterOne) {
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  int blind = 0;
  sea.spoil = [&](HookbehInputs& in) {
    blind += sea.truth > 30 || blind > 0;
    in.depth_m = blind > 0 && blind < 60 ? kNan : in.depth_m;
    in.altitude_m = blind > 0 ? 15 : kNan;
  };
  sea.yo(0.5);
  EXPECT_GT(blind, 60);
  EXPECT_EQ(sea.guarded, 0) << "by a bottom";
  EXPECT_GT(deepestIn(sea, 1), 54);
}

TEST(HookbehRelease, ASchoolOfFishIsNotABottomForLong) {
  for (const int echoes : {1, 7, 12, 29}) {
    ShallowSea sea;
    sea.bottom = deepWater;
    int heard = 0;
    sea.altitude = [&](double) {
      const bool now = heard < echoes && (heard > 0 || sea.truth > 10);
      heard += now;
      return now ? 30 - sea.truth : kNan;
    };
    sea.yo(2);
    EXPECT_GT(deepestIn(sea, 1), 54) << echoes;
  }
}

/// The depth repeats its zero at the surface, and for a while the vehicle does not get away from
/// it.
TEST(HookbehRelease, ADiveThatBeginsLateIsTriedAgain) {
  HookbehSea sea;
  const auto clipped = [&](HookbehInputs& in) { in.depth_m = sea.truth < 0.3 ? 0 : in.depth_m; };
  sea.held = true;
  sea.truth = 0;
  sea.take(50);
  ASSERT_LT(sea.until(HookGuard::NoDepthGained, clipped), 60);
  sea.held = false;
  sea.run(170, clipped);
  sea.deepest = 0;
  sea.run(250, clipped);
  EXPECT_GT(sea.deepest, 49);
}

/// A depth that is stuck at zero looks the same: it is tried again more and more rarely, and no
/// dive goes deeper than the first.
TEST(HookbehRelease, ADepthThatIsStuckAtZeroIsTriedAgainMoreAndMoreRarely) {
  HookbehSea sea;
  const auto stuck = [](HookbehInputs& in) { in.depth_m = 0; };
  sea.take(50);
  int tries = 0, last = 0, between = 0;
  bool guarded = false;
  for (int i = 0; i < 10000; ++i) {
    const bool now = sea.cycle(stuck).guard == HookGuard::NoDepthGained;
    if (guarded && !now) {
      tries += 1;
      EXPECT_GE(i - last, between) << "not sooner than the time before";
      between = i - last;
      last = i;
    }
    guarded = now;
  }
  EXPECT_GE(tries, 4);
  EXPECT_LE(tries, 9) << "in eleven hours";
  EXPECT_LE(sea.deepest, 30);
}

/// The sensor array keeps a reading for as long as c_pressure_time says.
TEST(HookbehRelease, OneFalseDepthThatTheArrayKeepsIsOneReading) {
  for (const int kept : {1, 2, 3, 4}) {
    for (const double off : {20.0, -12.0}) {
      HookbehSea sea;
      int cycles = 0, false_at = -1;
      double reading = 0.5;
      const auto rare = [&](HookbehInputs& in) {
        if (++cycles % kept == 0) {
          reading = in.depth_m;
          if (false_at < 0 && cycles > 100 && sea.truth > 20) {
            false_at = cycles;
            reading += off;
          }
        }
        in.depth_m = reading;
      };
      sea.run(60, rare);
      sea.take(50);
      sea.run(120, rare);
      ASSERT_GT(false_at, 0);
      EXPECT_EQ(sea.out.guard, HookGuard::None) << kept << " cycles, " << off;
    }
  }
}

TEST(HookbehRelease, NothingButATargetEndsTheClimbOfAVehicleThatDoesNotRise) {
  HookbehSea sea;
  sea.diveTo(20, 50);
  sea.held = true;
  Instruction up = HookbehBench::vertical(HookVertical::Surface);
  up.depth_m = 100;  // it means nothing here
  sea.bench.write(up);
  ASSERT_LT(sea.until(HookGuard::NoHeightGained, kNothing), 100);
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(sea.cycle().guard, HookGuard::NoHeightGained);
  }
}

/// A slow vehicle that hovers at 20 m until its depth has to be checked soon. In the last cycles
/// there is no reading, and so it climbs for a guard.
HookbehSea hoverUntilACheck(int cycles, int missing) {
  HookbehSea sea;
  sea.diveTo(18, 20);
  sea.bench.write(HookbehBench::vertical(HookVertical::Hover, 20));
  sea.run(cycles, kNothing);
  sea.full_mps = 0.15;
  for (int i = 0; i < missing; ++i) {
    EXPECT_EQ(sea.cycle([](HookbehInputs& in) { in.depth_m = kNan; }).guard,
              HookGuard::DepthUnknown);
  }
  return sea;
}

/// What it does where the check ends, 2 to 6 m above the depth of its hover.
Doing afterTheCheck(HookbehSea& sea) {
  for (int i = 0; i < 60 && sea.out.doing == Doing::CheckDepth; ++i) {
    sea.cycle();
  }
  EXPECT_GT(sea.truth, 14);
  EXPECT_LT(sea.truth, 18);
  return sea.out.doing;
}

TEST(HookbehRelease, ACheckOfTheDepthAloneIsFollowedByTheHover) {
  HookbehSea sea = hoverUntilACheck(97, 0);
  for (int i = 0; i < 60 && sea.out.doing != Doing::CheckDepth; ++i) {
    sea.cycle();
  }
  EXPECT_EQ(afterTheCheck(sea), Doing::Hover);
}

TEST(HookbehRelease, ACheckOfTheDepthThatFollowsOnAGuardIsFollowedByADive) {
  for (const auto& [cycles, missing] :
       {std::pair{97, 1}, {98, 1}, {100, 1}, {101, 1}, {95, 2}, {97, 2}, {100, 2}}) {
    HookbehSea sea = hoverUntilACheck(cycles, missing);
    EXPECT_EQ(sea.cycle().doing, Doing::CheckDepth) << cycles << " " << missing;
    EXPECT_EQ(afterTheCheck(sea), Doing::DiveTo) << cycles << " " << missing;
  }
}

}  // namespace
}  // namespace glider::hooks
