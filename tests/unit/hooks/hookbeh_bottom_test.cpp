// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// hookbeh over a bottom that the altimeter does not show, or shows only now and then.

#include "hooks/hookbeh/bottom.h"
#include "hooks/hookbeh/echo_floor.h"
#include "tests/unit/hooks/begun.h"
#include "tests/unit/hooks/hookbeh_shallow_sea.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::hooks {
namespace {

/// Cycles until the vehicle has touched the bottom and climbed clear of it.
void touchOnce(ShallowSea& sea) {
  for (int i = 0; i < 400 && sea.touches == 0; ++i) {
    sea.cycle();
  }
  ASSERT_EQ(sea.touches, 1);
  for (int i = 0; i < 60 && !(sea.touches == 1 && sea.truth < sea.bottom(0) - 3); ++i) {
    sea.cycle();
  }
  ASSERT_LT(sea.truth, sea.bottom(0) - 3) << "it climbs";
}

TEST(HookbehBottom, ADiveThatStopsOnTheBottomEndsInTime) {
  for (const bool has_ctd : {false, true}) {
    ShallowSea sea;
    sea.has_ctd = has_ctd;
    while (sea.touches == 0 && sea.bench.inputs.time_s < 2000) {
      sea.cycle();
    }
    int cycles = 0;
    while (sea.out.guard == HookGuard::None && cycles < 100) {
      sea.cycle();
      ++cycles;
    }
    EXPECT_EQ(sea.out.guard, HookGuard::NoDepthGained);
    EXPECT_LE(cycles * 4, has_ctd ? 188 : 90) << "s on the bottom";
  }
}

TEST(HookbehBottom, ABottomThatWasTouchedIsNotTouchedAgain) {
  ShallowSea sea;
  sea.yo(2);
  EXPECT_EQ(sea.touches, 1);
  sea.deepest = 0;
  sea.yo(0.5);
  EXPECT_EQ(sea.touches, 1);
  EXPECT_LT(sea.deepest, 36) << "5 m and 2 m above it, and the pump takes some time";
  EXPECT_GT(sea.deepest, 32) << "it dives on";
}

TEST(HookbehBottom, ADiveThatStandsStillHasTouchedItWhateverEndsTheDive) {
  // The SBC turns by itself after so many cycles on the bottom.
  for (const int cycles : {1, 7, 12}) {
    ShallowSea sea;
    while (sea.touches == 0) {
      sea.cycle();
    }
    for (int i = 0; i < cycles; ++i) {
      sea.cycle();
    }
    ASSERT_EQ(sea.out.guard, HookGuard::None);
    sea.bench.write(HookbehBench::ascend(4));
    while (sea.truth > 5) {
      sea.cycle();
    }
    ASSERT_EQ(sea.touches, 1);
    sea.bench.write(HookbehBench::descend(55));
    for (int i = 0; i < 200; ++i) {
      sea.cycle();
    }
    EXPECT_EQ(sea.touches, cycles >= 7 ? 1 : 2) << cycles << " cycles";
  }
}

TEST(HookbehBottom, ADiveThatOnlyBeginsHasTouchedNothing) {
  // The vehicle hovers, and the dive is called off before the pump has acted.
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  sea.bench.write(HookbehBench::descend(30));
  for (int i = 0; i < 150; ++i) {
    sea.cycle();
  }
  ASSERT_NEAR(sea.truth, 30, 5);
  sea.bench.write(HookbehBench::descend(55));
  for (int i = 0; i < 7; ++i) {
    sea.cycle();
  }
  sea.bench.write(HookbehBench::ascend(4));
  while (sea.truth > 4) {
    sea.cycle();
  }
  sea.bench.write(HookbehBench::descend(55));
  sea.yo(0.5);
  EXPECT_GT(sea.deepest, 54);
  EXPECT_EQ(sea.guarded, 0);
}

TEST(HookbehBottom, ATouchedBottomIsRememberedInSwellOfAMetre) {
  for (const double period : {7.0, 10.0, 13.0}) {
    for (double phase = 0; phase < 6; phase += 0.5) {
      ShallowSea sea;
      sea.spoil = [&](HookbehInputs& in) {
        const double swell = std::sin(2 * M_PI * in.time_s / period + phase);
        in.depth_m = std::max(0.0, in.depth_m + swell);
      };
      sea.yo(2.5);
      EXPECT_EQ(sea.touches, 1) << period << " s, " << phase;
    }
  }
}

TEST(HookbehBottom, ATouchedBottomIsRememberedByRareReadings) {
  for (const int kept : {2, 3, 4}) {
    for (const double full_mps : {0.2, 0.3}) {
      ShallowSea sea;
      sea.full_mps = full_mps;
      int cycles = 0;
      double reading = 0.5;
      sea.spoil = [&](HookbehInputs& in) {
        reading = ++cycles % kept == 0 ? in.depth_m + 0.01 * std::sin(cycles) : reading;
        in.depth_m = reading;
      };
      sea.yo(2.5);
      EXPECT_EQ(sea.touches, 1) << kept << " cycles, " << full_mps << " m/s";
    }
  }
}

/// The first reading after the stop is already metres higher.
TEST(HookbehBottom, AStopIsConfirmedByAReadingThatTheVehicleCanHaveReached) {
  for (const auto& [climbed_m, confirmed] : {std::pair{9.0, true}, {10.0, false}}) {
    const Surroundings now{40, 0, kNan, kNan, 3910, -7350};
    HookBottom bottom = begun(hookBottomInit);
    const auto cycle = [&](double depth_m) {
      hookBottomObserve(&bottom, &now, depth_m, 5, 4);
      hookBottomFollow(&bottom, 4);
    };
    cycle(40);
    hookBottomNoteStop(&bottom);
    for (int i = 0; i < 3; ++i) {
      cycle(40);
    }
    cycle(40 - climbed_m);
    EXPECT_EQ(hookIsFloorKnown(hookBottomTouchedFloor(&bottom)), confirmed) << climbed_m;
  }
}

TEST(HookbehBottom, ATouchedBottomIsRememberedWhereThePositionIsUnknown) {
  ShallowSea sea;
  sea.knows_position = false;
  sea.yo(12);
  EXPECT_EQ(sea.touches, 1);
}

TEST(HookbehBottom, FarFromATouchedBottomTheVehicleGoesDeeperLittleByLittle) {
  ShallowSea sea;
  sea.bottom = [](double north) { return north < 1000 ? 40 : 200; };
  touchOnce(sea);
  sea.yo(2.6);
  ASSERT_LT(sea.north, 3000);
  EXPECT_LT(sea.deepest, 40.1);
  sea.yo(1);
  EXPECT_LT(sea.deepest, 50) << "at " << sea.north << " m";
  sea.yo(3);
  EXPECT_GT(sea.deepest, 50) << "at " << sea.north << " m";
}

TEST(HookbehBottom, APositionThatJumpsIsNotFar) {
  ShallowSea sea;
  touchOnce(sea);
  sea.bench.inputs.longitude_ddmm = -5000;
  sea.yo(0.5);
  EXPECT_EQ(sea.touches, 1);
}

TEST(HookbehBottom, ARisingBottomIsNotTouchedInEachDive) {
  ShallowSea sea;
  sea.bottom = [](double north) {
    return north < 700 ? 60 : std::max(14.0, 60 - (north - 700) * 0.12);
  };
  sea.yo(2.5);
  EXPECT_GE(sea.touches, 1) << "there is no way to know";
  EXPECT_LE(sea.touches, 2) << "two contacts give the slope";
  EXPECT_GT(sea.north, 1500) << "it flies on, over 14 m of water";
}

TEST(HookbehBottom, AStoppedDepthThatDoesNotFollowTheClimbIsNoBottom) {
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  while (sea.truth < 20) {
    sea.cycle();
  }
  const double stuck = sea.bench.inputs.depth_m;
  int cycles = 0;
  sea.spoil = [&](HookbehInputs& in) { in.depth_m = stuck + (++cycles % 2 == 0 ? 0.01 : 0); };
  for (int i = 0; i < 120; ++i) {  // while the vehicle sinks on, and then climbs
    sea.cycle();
  }
  sea.spoil = [](HookbehInputs&) {};
  sea.has_ctd = true;  // which makes a depth that has jumped believed again
  while (sea.truth > 0.5) {
    sea.cycle();
  }
  sea.yo(1);
  EXPECT_GT(sea.deepest, 54) << "no bottom is remembered at " << stuck;
}

/// From now on depth and CTD stick where they are, and flicker; returns the depth.
double stickBoth(ShallowSea& sea) {
  const double stuck = sea.bench.inputs.depth_m;
  sea.spoil = [stuck, flips = false](HookbehInputs& in) mutable {
    flips = !flips;
    in.depth_m = stuck + (flips ? 0 : 0.01);
    in.ctd_bar = in.depth_m / 10;
  };
  return stuck;
}

/// The depth sticks while the vehicle dives on, and so does the CTD; both jump to where it is, and
/// are believed again in the middle of the climb.
TEST(HookbehBottom, AStopIsNotNotedWhereADepthIsBelievedAgain) {
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  sea.has_ctd = true;
  while (sea.truth < 20) {
    sea.cycle();
  }
  stickBoth(sea);
  for (int i = 0; i < 30; ++i) {  // too short for guard 7
    sea.cycle();
  }
  ASSERT_EQ(sea.out.guard, HookGuard::None);
  sea.spoil = [](HookbehInputs&) {};
  sea.cycle();
  ASSERT_EQ(sea.out.guard, HookGuard::DepthJumps);
  sea.bench.write(HookbehBench::ascend(4));
  sea.dives = false;
  sea.yo(1);
  EXPECT_EQ(sea.guarded, 0) << "no bottom is remembered where the depth was believed again";
  EXPECT_GT(sea.deepest, 54);
}

/// A depth that has stuck over dives and climbs is freed where the vehicle happens to be.
TEST(HookbehBottom, AStopIsNotConfirmedByADepthThatDidNotFollowTheClimbBefore) {
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  sea.has_ctd = true;
  while (sea.truth < 13) {
    sea.cycle();
  }
  const double stuck = stickBoth(sea);
  for (int dive = 0; dive < 3; ++dive) {  // 64 s down, 64 s up
    sea.bench.write(HookbehBench::descend(55));
    for (int i = 0; i < 16; ++i) {
      sea.cycle();
    }
    sea.bench.write(HookbehBench::ascend(4));
    for (int i = 0; i < 16; ++i) {
      sea.cycle();
    }
  }
  sea.bench.write(HookbehBench::descend(55));
  for (int i = 0; i < 16; ++i) {
    sea.cycle();
  }
  sea.bench.write(HookbehBench::ascend(4));
  while (sea.truth > stuck + 1) {
    sea.cycle();
  }
  ASSERT_EQ(sea.out.guard, HookGuard::None);
  sea.spoil = [](HookbehInputs&) {};
  sea.dives = false;
  sea.yo(1);
  EXPECT_EQ(sea.guarded, 0) << "no bottom is remembered at " << stuck;
  EXPECT_GT(sea.deepest, 54);
}

TEST(HookbehBottom, AfterALongDoubtADiveCountsFromItsBeginning) {
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  sea.has_ctd = true;
  while (sea.truth < 45) {
    sea.cycle();
  }
  bool up = false;
  sea.spoil = [&](HookbehInputs& in) { in.depth_m += (up = !up) ? -20 : 10; };
  for (int i = 0; i < 30; ++i) {
    sea.cycle();
  }
  sea.spoil = [](HookbehInputs&) {};
  for (int i = 0; i < 900; ++i) {
    sea.yo(1.0 / 900);
    ASSERT_NE(sea.out.guard, HookGuard::NoDepthGained) << sea.truth;
  }
  EXPECT_EQ(sea.guarded, 0);
  EXPECT_GT(sea.deepest, 54);
}

TEST(HookbehBottom, FalseReadingsAtTheBeginningAreNoDepthToPass) {
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  sea.cycle();
  sea.spoil = [](HookbehInputs& in) { in.depth_m = 50 + in.depth_m / 100; };
  for (int i = 0; i < 4; ++i) {
    sea.cycle();
  }
  sea.spoil = [](HookbehInputs&) {};
  for (int i = 0; i < 300; ++i) {
    sea.yo(1.0 / 900);
    ASSERT_NE(sea.out.guard, HookGuard::NoDepthGained) << sea.truth;
  }
  EXPECT_GT(sea.deepest, 54);
}

/// 15 m are not enough for a vehicle that stays 10 m above the bottom.
TEST(HookbehBottom, WhereTheVehicleCannotDiveItTriesAgainAfterHalfAnHour) {
  HookbehArgs args = ShallowSea::wide();
  args.least_altitude_m = 10;
  ShallowSea sea(args);
  sea.bottom = [](double) { return 15; };
  sea.yo(0.5);
  EXPECT_EQ(sea.touches, 1);
  sea.yo(0.5);
  EXPECT_EQ(sea.touches, 2);
}

/// Some echoes in a row may come by chance.
TEST(EchoFloor, IsNotRuledOutSoonerAfterSomeShortGaps) {
  HookEchoFloor echoes = begun(hookEchoFloorInit);
  double altitude = 15;
  const auto echo = [&] {
    hookEchoFloorObserve(&echoes, 15, altitude = 30 - altitude + 0.01, 15, 4);
  };
  const auto silence = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      hookEchoFloorObserve(&echoes, 15, altitude, 15, 4);
    }
  };
  for (int i = 0; i < 20; ++i) {
    echo();
    silence(19);
  }
  for (int i = 0; i < 6; ++i) {
    echo();
  }
  silence(60);
  EXPECT_LT(echoes.floor_m, 31);
  silence(80);
  EXPECT_GT(echoes.floor_m, 31);
}

/// A reading is missing, and hookbeh climbs for that cycle: the dive turns, and stands for a while
/// where it turns back.
TEST(HookbehBottom, ADiveThatAMissingReadingInterruptsHasNotStopped) {
  for (double depth_m = 10; depth_m < 50; depth_m += 2) {
    ShallowSea sea;
    sea.bottom = [](double) { return 500; };
    while (sea.truth < depth_m) {
      sea.cycle();
    }
    const double held_m = sea.truth;
    sea.spoil = [](HookbehInputs& in) { in.depth_m = kNan; };
    sea.cycle();
    sea.spoil = [&](HookbehInputs& in) {
      sea.truth = held_m;
      in.depth_m = held_m + sea.noise;
    };
    for (int i = 0; i < 8; ++i) {
      sea.cycle();
    }
    sea.bench.write(HookbehBench::ascend(4));
    sea.dives = false;
    sea.cycle();
    sea.cycle();
    sea.spoil = [](HookbehInputs&) {};
    sea.yo(0.5);
    EXPECT_EQ(sea.guarded, 0) << "no bottom is remembered at " << depth_m << " m";
  }
}

TEST(HookbehBottom, AnAltimeterThatReadsTooMuchIsNotBelievedAfterAContact) {
  ShallowSea sea;
  sea.altitude = [](double height) { return height + 20; };
  sea.yo(2);
  EXPECT_EQ(sea.touches, 1);
}

TEST(HookbehBottom, AnAltimeterThatAgreesAgainIsBelievedAgain) {
  ShallowSea sea;
  sea.altitude = [](double height) { return height + 20; };
  touchOnce(sea);
  sea.bottom = [](double north) { return north < 400 ? 40 : 90; };
  sea.altitude = [](double height) { return height >= 2 ? height : kNan; };
  sea.yo(1.2);
  EXPECT_GT(sea.deepest, 54) << "over 90 m of water, as the altimeter shows";
}

TEST(HookbehBottom, AnAltimeterThatIsStuckIsNotBelievedWhereItHappensToAgree) {
  for (const double stuck : {8.0, 20.0, 30.0}) {
    ShallowSea sea;
    sea.altitude = [=](double height) { return stuck + height * 1e-3; };
    sea.yo(2);
    EXPECT_LE(sea.touches, 1) << stuck;
  }
}

TEST(HookbehBottom, BetweenRareEchoesItStaysAboveARisingBottom) {
  for (const uint64_t first : {8U, 12U, 16U, 20U, 24U, 28U}) {
    ShallowSea sea;
    sea.bottom = [](double north) { return std::max(30.0, 110 - north * 0.1); };
    uint64_t cycles = first;
    sea.altitude = [&](double height) { return height < 36 && ++cycles % 30 == 0 ? height : kNan; };
    sea.yo(1);
    EXPECT_EQ(sea.touches, 0) << first;
  }
}

TEST(HookbehBottom, AnAltimeterThatDiesOverTheBottomIsNoDeepWater) {
  ShallowSea sea;
  sea.altitude = [](double height) { return height >= 2 ? height : kNan; };
  sea.yo(0.4);
  EXPECT_EQ(sea.touches, 0);
  sea.altitude = [](double) { return kNan; };
  sea.yo(2);
  EXPECT_EQ(sea.touches, 0);
}

TEST(HookbehBottom, WhereNoAltimeterIsUsedABottomThatWasTouchedCounts) {
  HookbehArgs args = ShallowSea::wide();
  args.least_altitude_m = -1;
  ShallowSea sea(args);
  sea.yo(2);
  EXPECT_EQ(sea.touches, 1);
}

TEST(HookbehBottom, AnAltimeterOfShortRangeLeavesAHealthyVehicleAlone) {
  for (const double range : {10.0, 36.0, 100.0}) {
    ShallowSea sea;
    sea.bottom = [](double north) { return 90 + 15 * std::sin(north / 100); };
    sea.altitude = [=](double height) { return height <= range ? height : kNan; };
    sea.yo(3);
    EXPECT_EQ(sea.guarded, 0) << range;
    EXPECT_GT(sea.deepest, 54) << range;
  }
}

TEST(HookbehBottom, ALoneEchoIsApproachedAgainLittleByLittle) {
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  int echoes = 0;
  sea.altitude = [&](double) { return sea.truth > 20 && echoes++ == 0 ? 15.0 : kNan; };
  sea.yo(0.3);
  EXPECT_LT(sea.deepest, 33) << "5 m above it";
  sea.deepest = 0;
  sea.yo(0.2);
  EXPECT_LT(sea.deepest, 35) << "a bottom does not go away in minutes";
  sea.yo(1);
  EXPECT_GT(sea.deepest, 54) << "but there was none in all that time";
}

TEST(HookbehBottom, AFishDoesNotKeepTheVehicleUp) {
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  int cycles = 0;
  sea.altitude = [&](double) { return ++cycles % 900 == 60 ? 8.0 + cycles * 1e-4 : kNan; };
  sea.yo(1);
  sea.deepest = 0;
  sea.yo(1);
  EXPECT_GT(sea.deepest, 54);
}

TEST(HookbehBottom, BubblesNearTheSurfaceDoNotKeepTheVehicleUp) {
  ShallowSea sea;
  sea.bottom = [](double) { return 500; };
  int cycles = 0;
  sea.altitude = [&](double) {
    return sea.truth > 2 && sea.truth < 4 && ++cycles % 300 < 3 ? 2.5 + cycles * 1e-4 : kNan;
  };
  sea.yo(2);
  EXPECT_GT(sea.deepest, 54);
}

TEST(HookbehBottom, AtTheSurfaceAnOldEchoIsNotForgotten) {
  HookEchoFloor echoes = begun(hookEchoFloorInit);
  hookEchoFloorObserve(&echoes, 15, 5, 15, 4);
  for (int i = 0; i < 2000; ++i) {
    hookEchoFloorObserve(&echoes, 0.5, kNan, 15, 4);
  }
  EXPECT_LT(echoes.floor_m, 21) << "at the surface the altimeter receives nothing";
}

TEST(HookbehBottom, TheAltimeterIsAskedForWhileHookbehCommands) {
  HookbehBench bench;
  EXPECT_FALSE(bench.cycle().altimeter) << "it waits";
  EXPECT_TRUE(bench.give(HookbehBench::take(20)).altimeter);
  HookbehArgs args;
  args.least_altitude_m = -1;
  HookbehBench without(args);
  without.cycle();
  EXPECT_FALSE(without.give(HookbehBench::take(20)).altimeter);
}

}  // namespace
}  // namespace glider::hooks
