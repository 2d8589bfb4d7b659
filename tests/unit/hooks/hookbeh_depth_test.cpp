// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A depth that cannot be believed: what hookbeh makes of it.

#include "tests/unit/hooks/hookbeh_sea.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

using Sea = HookbehSea;

TEST(HookbehDepth, OutsideWhatADepthSensorGivesItIsUnknown) {
  for (const double wrong :
       {-50.0, -5.1, 300.1, 1e9, -1e30, std::numeric_limits<double>::infinity()}) {
    Sea sea;
    sea.diveTo(20, 50);
    sea.cycle([=](HookbehInputs& in) { in.depth_m = wrong; });
    EXPECT_STREQ(wordsFor(sea.out.doing), "climb: depth unknown") << wrong;
    EXPECT_EQ(sea.out.guard, HookGuard::DepthUnknown);
    EXPECT_GT(sea.out.pump_cc, 0);
    EXPECT_EQ(sea.cycle().guard, HookGuard::None) << "one reading is forgiven";
  }
}

TEST(HookbehDepth, AtTheEdgesOfWhatASensorGivesItIsKnown) {
  Bench bench;
  bench.cycle();
  bench.inputs.depth_m = -4.9;
  EXPECT_STREQ(wordsFor(bench.give(Bench::take(20)).doing), "dive_to");
}

TEST(HookbehDepth, ADepthThatJumpsMakesTheVehicleClimbUntilItFollowsAgain) {
  for (const double jump : {-20.0, 20.0}) {
    Sea sea;
    sea.diveTo(30, 55);
    sea.cycle([=](HookbehInputs& in) { in.depth_m += jump; });
    EXPECT_STREQ(wordsFor(sea.out.doing), "climb: depth jumps") << jump;
    EXPECT_EQ(sea.out.guard, HookGuard::DepthJumps);
    sea.cycle();
    EXPECT_STREQ(wordsFor(sea.out.doing), "dive_to") << "nor has it reached anything in between";
  }
}

TEST(HookbehDepth, ADepthThatJumpsAndStaysAwayIsNotBelievedWithoutACtd) {
  Sea sea;
  sea.diveTo(45, 55);
  sea.run(600, [](HookbehInputs& in) { in.depth_m = std::max(0.0, in.depth_m - 25); });
  EXPECT_EQ(sea.out.guard, HookGuard::DepthJumps);
  EXPECT_LT(sea.deepest, 50);
  EXPECT_LT(sea.truth, 1);
}

TEST(HookbehDepth, ADepthThatJumpsAndStaysAwayIsBelievedWhenTheCtdAgreesAgain) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(45, 55);
  sea.run(50, [](HookbehInputs& in) { in.depth_m = std::max(0.0, in.depth_m - 25); });
  EXPECT_NE(sea.out.guard, HookGuard::None);
  const int cycles = sea.until(HookGuard::None, kNothing);
  EXPECT_GE(cycles, 14) << "after 60 s";
  EXPECT_LE(cycles, 60);
}

/// At the surface a CTD may say exactly the same all the time.
TEST(HookbehDepth, ADepthThatJumpsBackAtTheSurfaceIsBelievedIfTheCtdIsConstant) {
  for (const int stuck_cycles : {18, 25}) {
    Sea sea;
    const auto rests = [](HookbehInputs& in) { in.ctd_bar = 0; };
    sea.run(stuck_cycles, [](HookbehInputs& in) { in.depth_m = 65.6, in.ctd_bar = 0; });
    sea.bench.write(Bench::take(30));
    sea.run(5, rests);
    EXPECT_EQ(sea.out.guard, HookGuard::DepthJumps) << stuck_cycles;
    EXPECT_LE(sea.until(HookGuard::None, rests), 250) << stuck_cycles;
  }
}

/// Half of its readings are wrong by up to 50 m, some of them outside of what a depth can be. The
/// CTD rests at the surface meanwhile.
TEST(HookbehDepth, ADepthThatJumpedForLongIsBelievedAtTheSurfaceIfTheCtdIsConstant) {
  for (unsigned seed = 1; seed < 60; ++seed) {
    Sea sea;
    sea.has_ctd = true;
    sea.diveTo(20, 25);
    const auto rests = [](HookbehInputs& in) { in.ctd_bar = in.ctd_bar < 0.02 ? 0 : in.ctd_bar; };
    unsigned random = seed;
    sea.run(120, [&](HookbehInputs& in) {
      random = random * 1103515245 + 12345;
      const double off = static_cast<double>(random >> 16 & 0x7fff) / 0x7fff * 100 - 50;
      in.depth_m = (random & 0x4000) != 0 ? in.depth_m : std::max(-40.0, in.depth_m + off);
      rests(in);
    });
    EXPECT_EQ(sea.truth, 0);
    EXPECT_LE(sea.until(HookGuard::None, rests), 250) << seed;
  }
}

/// The depth waves about a value that it left long ago, and then jumps to where the vehicle is: at
/// the surface, where the CTD has rested meanwhile.
TEST(HookbehDepth, ADepthThatDisagreedIsBelievedAtTheSurfaceIfTheCtdIsConstant) {
  for (const double phase : {0.0, 1.5, 3.0, 4.5}) {
    Sea sea;
    sea.has_ctd = true;
    sea.diveTo(30, 55);
    sea.bench.write(Bench::ascend(4));
    const double stuck = sea.bench.inputs.depth_m;
    const auto rests = [](HookbehInputs& in) { in.ctd_bar = in.ctd_bar < 0.02 ? 0 : in.ctd_bar; };
    sea.run(120, [&, i = 0](HookbehInputs& in) mutable {
      in.depth_m = stuck + 2.4 * __builtin_sin(0.7 * ++i + phase);
      rests(in);
    });
    EXPECT_EQ(sea.truth, 0);
    EXPECT_NE(sea.out.guard, HookGuard::None);
    EXPECT_LE(sea.until(HookGuard::None, rests), 250) << phase;
  }
}

TEST(HookbehDepth, FrozenOnTheWayDownItClimbsInTime) {
  for (const bool ctd : {false, true}) {
    Sea sea;
    sea.has_ctd = ctd;
    sea.diveTo(50, 58);
    const double frozen = sea.bench.inputs.depth_m;
    const auto freeze = [=](HookbehInputs& in) { in.depth_m = frozen; };
    EXPECT_LE(sea.until(HookGuard::DepthFrozen, freeze), 5) << "16 s";
    EXPECT_STREQ(wordsFor(sea.out.doing), "climb: depth frozen");
    sea.run(500, freeze);
    EXPECT_EQ(sea.out.guard, HookGuard::DepthFrozen) << "for as long as it lasts";
    EXPECT_LT(sea.deepest, 60);
    EXPECT_EQ(sea.truth, 0) << "and the vehicle is at the surface";
  }
}

TEST(HookbehDepth, FrozenOnTheWayUpItClimbsOn) {
  Sea sea;
  sea.diveTo(40, 50);
  sea.bench.write(Bench::ascend(5));
  sea.run(8, kNothing);
  const double frozen = sea.bench.inputs.depth_m;
  EXPECT_LE(sea.until(HookGuard::DepthFrozen, [=](HookbehInputs& in) { in.depth_m = frozen; }), 5);
}

TEST(HookbehDepth, FrozenInHoverItClimbsWithinAMinute) {
  Sea sea;
  sea.diveTo(18, 20);
  sea.bench.write(Bench::vertical(HookVertical::Hover, 20));
  sea.run(40, kNothing);
  ASSERT_STREQ(wordsFor(sea.out.doing), "hover");
  const int cycles = sea.until(HookGuard::DepthFrozen, [](HookbehInputs& in) { in.depth_m = 20; });
  EXPECT_GE(cycles, 14);
  EXPECT_LE(cycles, 17);
}

TEST(HookbehDepth, AVehicleThatHangsStillAsTheCtdSeesIsNotFrozen) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(30, 50);
  const double still = sea.bench.inputs.depth_m;
  double wobble = 0.01;
  for (int i = 0; i < 24; ++i) {
    wobble = -wobble;
    sea.cycle([&](HookbehInputs& in) { in.depth_m = still, in.ctd_bar = (still + wobble) / 10; });
    ASSERT_EQ(sea.out.guard, HookGuard::None) << i;
  }
  const int cycles = sea.until(HookGuard::NoDepthGained, [&](HookbehInputs& in) {
    wobble = -wobble;
    in.depth_m = still, in.ctd_bar = (still + wobble) / 10;
  });
  EXPECT_NEAR(cycles, 45 - 24, 2) << "180 s in all";
}

TEST(HookbehDepth, ADepthFrozenTogetherWithTheCtdIsFrozen) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(50, 58);
  const HookbehInputs frozen = sea.bench.inputs;
  EXPECT_LE(sea.until(HookGuard::DepthFrozen,
                      [&](HookbehInputs& in) {
                        in.depth_m = frozen.depth_m, in.ctd_bar = frozen.ctd_bar;
                      }),
            5);
}

TEST(HookbehDepth, ADepthThatChangesAgainIsBelievedAtTheSurface) {
  Sea sea;
  sea.diveTo(40, 50);
  const double frozen = sea.bench.inputs.depth_m;
  sea.run(10, [=](HookbehInputs& in) { in.depth_m = frozen; });
  ASSERT_EQ(sea.out.guard, HookGuard::DepthFrozen);
  double highest = 100;
  int cycles = 0;
  while (sea.cycle().guard != HookGuard::None && cycles < 500) {
    highest = std::min(highest, sea.truth);
    ++cycles;
  }
  EXPECT_LT(highest, 3.1) << "not before it was there";
  EXPECT_LT(cycles, 200);
  EXPECT_STREQ(wordsFor(sea.out.doing), "dive_to");
}

TEST(HookbehDepth, ADepthThatChangesAgainNearTheSurfaceIsBelievedAfterTwoMinutesOfClimbing) {
  Sea sea;
  sea.diveTo(4, 50);
  const double frozen = sea.bench.inputs.depth_m;
  sea.run(10, [=](HookbehInputs& in) { in.depth_m = frozen; });
  ASSERT_EQ(sea.out.guard, HookGuard::DepthFrozen);
  const int cycles = sea.until(HookGuard::None, kNothing);
  EXPECT_GE(cycles, 27);
  EXPECT_LE(cycles, 35);
}

TEST(HookbehDepth, ADepthThatChangesAgainIsBelievedAfterAMinuteIfTheCtdAgrees) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(40, 50);
  const double frozen = sea.bench.inputs.depth_m;
  sea.run(10, [=](HookbehInputs& in) { in.depth_m = frozen; });
  ASSERT_EQ(sea.out.guard, HookGuard::DepthFrozen);
  const int cycles = sea.until(HookGuard::None, kNothing);
  EXPECT_GE(cycles, 14);
  EXPECT_LE(cycles, 25);
}

TEST(HookbehDepth, ANewSessionDoesNotEndTheGuardOfAFrozenDepth) {
  Sea sea;
  sea.diveTo(40, 50);
  const double frozen = sea.bench.inputs.depth_m;
  const auto freeze = [=](HookbehInputs& in) { in.depth_m = frozen; };
  sea.run(10, freeze);
  sea.bench.alive = false;
  sea.run(8, freeze);
  ASSERT_EQ(sea.out.state, HookState::Silent);
  sea.bench.alive = true;
  sea.bench.write(Bench::take(50, 2));
  sea.cycle(freeze);
  EXPECT_EQ(sea.out.state, HookState::Active);
  EXPECT_EQ(sea.out.guard, HookGuard::DepthFrozen);
}

TEST(HookbehDepth, FrozenAtTheSurfaceADiveThatGainsNoDepthEndsInTime) {
  for (const double greatest : {12.0, 30.0, 60.0}) {
    Sea sea(greatest);
    sea.full_mps = 0.2;  // as fast as a vehicle at this pitch
    sea.take(greatest);
    const auto freeze = [](HookbehInputs& in) { in.depth_m = 0; };
    sea.until(HookGuard::NoDepthGained, freeze);
    EXPECT_STREQ(wordsFor(sea.out.doing), "climb: no depth gained");
    sea.run(1000, freeze);
    EXPECT_EQ(sea.out.guard, HookGuard::NoDepthGained) << "nothing says that it lives";
    EXPECT_LT(sea.deepest, greatest + 10);
    EXPECT_EQ(sea.truth, 0);
  }
}

/// The vehicle hangs for so long, or until a guard comes in.
HookGuard hang(Sea& sea, int cycles) {
  sea.held = true;
  for (int i = 0; i < cycles && sea.out.guard == HookGuard::None; ++i) {
    sea.cycle();
  }
  sea.held = false;
  return sea.out.guard;
}

TEST(HookbehDepth, ADiveThatGainsNoDepthHasThreeMinutesOrWhatItCanAfford) {
  struct Case {
    bool ctd;
    double depth;
    int least, most;  // cycles
  };
  for (const Case& c : {Case{true, 5, 43, 46},
                        {true, 50, 37, 41},
                        {false, 5, 43, 46},
                        {false, 30, 29, 33},
                        {false, 50, 7, 11}}) {
    Sea sea;
    sea.has_ctd = c.ctd;
    sea.diveTo(c.depth, 58);
    EXPECT_EQ(hang(sea, c.least), HookGuard::None) << c.depth;
    EXPECT_EQ(hang(sea, c.most - c.least), HookGuard::NoDepthGained) << c.depth;
  }
}

TEST(HookbehDepth, AfterADiveThatGainedNoDepthItIsTriedAgainFromHalfTheDepth) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(30, 50);
  ASSERT_EQ(hang(sea, 60), HookGuard::NoDepthGained);
  const double from = sea.truth;
  sea.until(HookGuard::None, kNothing);
  EXPECT_STREQ(wordsFor(sea.out.doing), "dive_to");
  EXPECT_NEAR(sea.truth, from / 2, 2);
}

TEST(HookbehDepth, ADiveThatGainedNoDepthNearTheSurfaceIsTriedAgainAfterTenMinutesIfTheDepthLives) {
  Sea sea;
  sea.diveTo(3, 50);
  ASSERT_EQ(hang(sea, 60), HookGuard::NoDepthGained);
  sea.held = true;
  const int cycles = sea.until(HookGuard::None, kNothing);
  EXPECT_NEAR(cycles, 150, 3);
  EXPECT_STREQ(wordsFor(sea.out.doing), "dive_to");
}

/// On the way up from 30 m, as `instruction` says.
void beginToClimb(Sea& sea, const Instruction& instruction) {
  sea.has_ctd = true;
  sea.diveTo(30, 50);
  sea.bench.write(instruction);
  sea.run(6, kNothing);
}

TEST(HookbehDepth, AClimbThatGainsNoHeightClimbsWithAllItHas) {
  Sea sea;
  beginToClimb(sea, Bench::ascend(5));
  const double at = sea.truth;
  EXPECT_EQ(hang(sea, 57), HookGuard::None);
  EXPECT_EQ(hang(sea, 8), HookGuard::NoHeightGained) << "240 s";
  EXPECT_STREQ(wordsFor(sea.out.doing), "climb: no height gained");
  EXPECT_NEAR(sea.out.pitch_rad, 0.4538, 1e-9);
  sea.until(HookGuard::None, kNothing);
  EXPECT_STREQ(wordsFor(sea.out.doing), "climb_to");
  EXPECT_LT(sea.truth, at - 0.9);
  EXPECT_GT(sea.truth, at - 4);
}

TEST(HookbehDepth, AWayToTheSurfaceThatGainsNoHeightClimbsWithAllItHas) {
  Sea sea;
  beginToClimb(sea, Bench::vertical(HookVertical::Surface, 0));
  EXPECT_EQ(hang(sea, 57), HookGuard::None);
  EXPECT_EQ(hang(sea, 8), HookGuard::NoHeightGained) << "240 s";
  sea.until(HookGuard::None, kNothing);
  EXPECT_STREQ(wordsFor(sea.out.doing), "surface");
}

TEST(HookbehDepth, AtTheSurfaceThereIsNoHeightToGain) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(10, 20);
  sea.bench.write(Bench::vertical(HookVertical::Surface, 0));
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(sea.cycle().guard, HookGuard::None) << i;
  }
  EXPECT_LT(sea.truth, 3);
}

TEST(HookbehDepth, AnInstructionToGoDeeperEndsAClimbThatGainsNoHeight) {
  Sea sea;
  beginToClimb(sea, Bench::ascend(5));
  ASSERT_EQ(hang(sea, 70), HookGuard::NoHeightGained);
  sea.held = true;
  sea.run(5, kNothing);
  EXPECT_EQ(sea.out.guard, HookGuard::NoHeightGained);
  sea.bench.write(Bench::descend(50));
  EXPECT_EQ(sea.cycle().guard, HookGuard::None);
}

TEST(HookbehDepth, AHoverThatTheWaterCarriesAwayIsGivenUp) {
  for (const double way : {0.3, -0.3}) {
    Sea sea;
    sea.diveTo(20, 20);
    sea.bench.write(Bench::vertical(HookVertical::Hover, 20));
    sea.run(20, kNothing);
    ASSERT_STREQ(wordsFor(sea.out.doing), "hover");
    sea.held = true;
    for (int i = 0; i < 30; ++i) {
      sea.truth += way;
      sea.cycle();
      ASSERT_EQ(sea.out.guard, HookGuard::None) << i;
    }
    EXPECT_EQ(hang(sea, 70), way > 0 ? HookGuard::NoHeightGained : HookGuard::NoDepthGained);
  }
}

TEST(HookbehDepth, AHoverThatTrimsWithItsPumpIsNotGivenUp) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(20, 20);
  sea.bench.write(Bench::vertical(HookVertical::Hover, 20));
  sea.run(20, kNothing);
  sea.held = true;
  for (int i = 0; i < 15; ++i) {
    sea.truth += 0.3;  // too heavy: it comes to rest 5 m below
    sea.cycle();
  }
  for (int i = 0; i < 500; ++i) {
    sea.held = sea.out.doing == Doing::Hover;
    ASSERT_EQ(sea.cycle().guard, HookGuard::None) << i;
  }
}

TEST(HookbehDepth, ADepthThatDriftsFromTheCtdsIsNotBelieved) {
  for (const double drift : {-0.05, 0.2}) {
    Sea sea;
    sea.has_ctd = true;
    sea.diveTo(drift < 0 ? 20 : 5, 58);
    double off = 0;
    const auto drifts = [&](HookbehInputs& in) {
      in.depth_m = std::max(0.0, in.depth_m + (off += 4 * drift));
    };
    for (int i = 0; i < 500 && sea.out.guard == HookGuard::None; ++i) {
      sea.cycle(drifts);
    }
    EXPECT_EQ(sea.out.guard, HookGuard::DepthsDisagree) << drift;
    EXPECT_STREQ(wordsFor(sea.out.doing), "climb: depths disagree");
    // In a dive the CTD may be late, so that a depth too great is found later.
    EXPECT_NEAR(std::fabs(off), drift < 0 ? 5.4 : 16.5, 1.5);
    EXPECT_LT(sea.deepest, 60);
  }
}

TEST(HookbehDepth, TheDeeperOfTheTwoCountsForTheLimit) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(50, 60);
  sea.until(HookGuard::TooDeep, [](HookbehInputs& in) { in.depth_m -= 4; });
  EXPECT_NEAR(sea.truth, 60, 1.5);
  Sea other;
  other.has_ctd = true;
  other.diveTo(50, 60);
  other.until(HookGuard::TooDeep, [](HookbehInputs& in) { in.ctd_bar -= 0.4; });
  EXPECT_NEAR(other.truth, 60, 1.5);
}

TEST(HookbehDepth, ACtdThatIsStuckOrMissingIsNotAsked) {
  for (const double value : {0.0, 2.0, 20.0, kNan, -3.0, 1e9}) {
    Sea sea;
    sea.has_ctd = true;
    sea.diveTo(20, 50);
    for (int i = 0; i < 60 && sea.truth < 49; ++i) {
      sea.cycle([=](HookbehInputs& in) { in.ctd_bar = value; });
      ASSERT_EQ(sea.out.guard, HookGuard::None) << value << " at " << sea.truth;
    }
    EXPECT_GT(sea.truth, 48);
  }
}

TEST(HookbehDepth, ACtdThatIsStuckToTheLastBitSaysNothingAboutAVehicleThatHangs) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(50, 58);
  sea.held = true;
  const double still = sea.bench.inputs.ctd_bar;
  const int cycles =
      sea.until(HookGuard::NoDepthGained, [=](HookbehInputs& in) { in.ctd_bar = still; });
  EXPECT_NEAR(cycles, 10, 2) << "10 m that it may sink unseen";
}

TEST(HookbehDepth, ACtdThatNeverAgreedIsNotAsked) {
  Sea sea;
  sea.has_ctd = true;
  sea.run(10, [](HookbehInputs& in) { in.ctd_bar += 3; });
  sea.take(50);
  for (int i = 0; i < 60 && sea.truth < 45; ++i) {
    sea.cycle([](HookbehInputs& in) { in.ctd_bar += 3; });
    ASSERT_EQ(sea.out.guard, HookGuard::None) << sea.truth;
  }
}

/// A vehicle that climbs was as deep some seconds ago as a CTD that is off by 7 m says.
TEST(HookbehDepth, ACtdThatIsOffBySevenMetresIsNotAsked) {
  for (const double off_bar : {0.7, -0.7}) {
    Sea sea;
    sea.has_ctd = true;
    const auto off = [=](HookbehInputs& in) { in.ctd_bar += off_bar; };
    sea.bench.write(Bench::take(50));
    for (int i = 0; i < 40; ++i) {
      sea.cycle(off);
    }
    sea.bench.write(Bench::ascend(4));
    for (int i = 0; i < 300; ++i) {
      sea.cycle(off);
      ASSERT_EQ(sea.out.guard, HookGuard::None) << sea.truth << " m, off by " << off_bar << " bar";
    }
  }
}

TEST(HookbehDepth, ACtdThatWasStuckIsAskedAgainWhenItMoves) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(20, 50);
  const double stuck = sea.bench.inputs.ctd_bar;
  sea.run(20, [=](HookbehInputs& in) { in.ctd_bar = stuck; });
  ASSERT_EQ(sea.out.guard, HookGuard::None);
  sea.run(3, kNothing);  // it moves, and agrees
  auto drifts = [off = 0.0](HookbehInputs& in) mutable { in.ctd_bar -= (off += 0.03); };
  EXPECT_LT(sea.until(HookGuard::DepthsDisagree, drifts), 40);
}

TEST(HookbehDepth, DepthsThatDisagreeAreBelievedAtTheSurfaceWhereTheyAgree) {
  Sea sea;
  sea.has_ctd = true;
  sea.diveTo(20, 58);
  const auto scaled = [](HookbehInputs& in) { in.depth_m *= 0.8; };
  sea.until(HookGuard::DepthsDisagree, scaled);
  double highest = 100;
  int cycles = 0;
  while (sea.cycle(scaled).guard != HookGuard::None && cycles < 500) {
    highest = std::min(highest, sea.truth);
    ++cycles;
  }
  EXPECT_LT(highest, 1);
  EXPECT_LT(cycles, 200);
  EXPECT_LT(sea.deepest, 45);
}

TEST(HookbehDepth, GuardsHaveTheNumbersOfTheReadme) {
  // Missions and logs rely on these numbers (README).
  EXPECT_EQ(static_cast<int>(HookGuard::TooDeep), 1);
  EXPECT_EQ(static_cast<int>(HookGuard::NearBottom), 2);
  EXPECT_EQ(static_cast<int>(HookGuard::DepthUnknown), 3);
  EXPECT_EQ(static_cast<int>(HookGuard::DepthJumps), 4);
  EXPECT_EQ(static_cast<int>(HookGuard::DepthFrozen), 5);
  EXPECT_EQ(static_cast<int>(HookGuard::DepthsDisagree), 6);
  EXPECT_EQ(static_cast<int>(HookGuard::NoDepthGained), 7);
  EXPECT_EQ(static_cast<int>(HookGuard::NoHeightGained), 8);
}

}  // namespace
}  // namespace glider::hooks
