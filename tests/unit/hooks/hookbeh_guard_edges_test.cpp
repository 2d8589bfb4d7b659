// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The guard by itself, at the very edges of its limits.

#include "hooks/hookbeh/guard.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/begun.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <tuple>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

constexpr VerticalCommand kOther{0, kNan}, kAdrift{0, 0};

/// A guard that gets the position of the vehicle. It commands nothing unless `last` is a command,
/// and the vehicle is driven `way`; to a depth far off the vehicle goes by 2 m a cycle, driven
/// nowhere.
struct GuardBench {
  explicit GuardBench(const Instruction& wanted = Bench::vertical(HookVertical::Surface))
      : in_force(wanted) {}

  HookGuard at(double depth_m, double altitude_m = kNan) {
    for (double far = depth_m - depth; std::fabs(far) > 2; far = depth_m - depth) {
      depth += std::copysign(2, far);
      hookbehGuardObserve(&guard, &args, given(Surroundings{depth, 0, kNan, kNan}), 4, &kOther,
                          HookWay::None);
      hookbehGuardMustClimb(&guard, &args, &in_force);
    }
    depth = std::isnan(depth_m) ? depth : depth_m;
    return cycle({depth_m, 0, altitude_m, ctd_m});
  }
  HookGuard cycle(const Surroundings& now) {
    hookbehGuardObserve(&guard, &args, &now, step_s, &last, way);
    return hookbehGuardMustClimb(&guard, &args, &in_force);
  }
  /// Cycles at `depth_m` that flickers in its last bits until `wanted`; at most 1000.
  int until(HookGuard wanted, double depth_m, double flicker = 0) {
    for (int cycles = 1; cycles <= 1000; ++cycles) {
      if (at(depth_m + (cycles % 2 == 0 ? flicker : 0)) == wanted) {
        return cycles;
      }
    }
    return 0;
  }

  HookbehGuard guard = begun(hookbehGuardInit, &kHull);
  HookbehArgs args;
  Instruction in_force;
  VerticalCommand last = kOther;
  HookWay way = HookWay::None;
  double step_s = 4;
  double depth = 10;
  double ctd_m = kNan;
};

TEST(HookbehGuardEdges, AtTheGreatestDepthItIsNotTooDeep) {
  GuardBench bench;
  EXPECT_EQ(bench.at(30), HookGuard::None);
  EXPECT_EQ(bench.at(30.25), HookGuard::TooDeep);
  EXPECT_EQ(bench.at(29.25), HookGuard::TooDeep);
  EXPECT_EQ(bench.at(29), HookGuard::None) << "a metre clear";
}

TEST(HookbehGuardEdges, AGuardEndsOnlyIfTheTargetIsAMetreAboveTheLimit) {
  for (const auto& [vertical, depth, clear] : {std::tuple{HookVertical::Hover, 29.25, false},
                                               {HookVertical::Hover, 29.0, true},
                                               {HookVertical::Ascend, 29.25, false},
                                               {HookVertical::Descend, 29.0, true},
                                               {HookVertical::Surface, 29.25, true},
                                               {HookVertical::None, 29.25, true}}) {
    GuardBench bench(Bench::vertical(vertical, depth));
    EXPECT_EQ(bench.at(30.25), HookGuard::TooDeep);
    EXPECT_EQ(bench.at(28) == HookGuard::None, clear) << depth;
  }
}

TEST(HookbehGuardEdges, AtTheLeastAltitudeItIsNotTooNear) {
  GuardBench bench;
  EXPECT_EQ(bench.at(10, 8), HookGuard::None);
  EXPECT_EQ(bench.at(13), HookGuard::None) << "of a bottom at 18 m";
  EXPECT_EQ(bench.at(13.25), HookGuard::NearBottom);
  EXPECT_EQ(bench.at(12.25), HookGuard::NearBottom);
  EXPECT_EQ(bench.at(12), HookGuard::None) << "a metre clear";
}

TEST(HookbehGuardEdges, ATargetIsAMetreClearOfTheBottomToo) {
  GuardBench bench(Bench::vertical(HookVertical::Hover, 12.25));
  bench.at(10, 8);
  EXPECT_EQ(bench.at(13.25), HookGuard::NearBottom);
  EXPECT_EQ(bench.at(11), HookGuard::NearBottom);
  bench.in_force.depth_m = 12;
  EXPECT_EQ(bench.at(11), HookGuard::None);
}

TEST(HookbehGuardEdges, NoAltitudeIsTooSmallToBeAnEcho) {
  for (const double altitude : {0.0, 1.0}) {
    EXPECT_EQ(GuardBench().at(10, altitude), HookGuard::NearBottom) << altitude;
  }
  EXPECT_EQ(GuardBench().at(10, -0.25), HookGuard::None);
}

TEST(HookbehGuardEdges, WhatIsNotAnEchoLeavesTheBottomWhereItIs) {
  for (const double wrong : {std::numeric_limits<double>::infinity(), kNan, -1.0}) {
    GuardBench bench;
    EXPECT_EQ(bench.at(10, 5.5), HookGuard::None);
    EXPECT_EQ(bench.at(10.75, wrong), HookGuard::NearBottom) << wrong;
  }
}

TEST(HookbehGuardEdges, AnEchoWithoutADepthIsNone) {
  GuardBench bench;
  EXPECT_EQ(bench.at(10), HookGuard::None);
  EXPECT_EQ(bench.at(kNan, 50), HookGuard::DepthUnknown);
  EXPECT_EQ(bench.at(10), HookGuard::None);
  EXPECT_EQ(bench.at(11, 50), HookGuard::None);
}

TEST(HookbehGuardEdges, FortySecondsAfterAnEchoTheBottomMayRise) {
  GuardBench bench;
  bench.at(12, 6);
  bench.step_s = 1;
  for (int i = 1; i <= 40; ++i) {
    ASSERT_EQ(bench.at(13, 6), HookGuard::None) << i << " s: 5 m above it";
  }
  EXPECT_EQ(bench.at(13, 6), HookGuard::NearBottom);
}

TEST(HookbehGuardEdges, WhereNoAltimeterIsUsedThereIsNoBottom) {
  GuardBench bench;
  bench.args.least_altitude_m = -1;
  EXPECT_EQ(bench.at(10, 0), HookGuard::None);
  EXPECT_EQ(bench.at(11.25), HookGuard::None) << "deeper than its bottom";
  GuardBench other;
  other.args.least_altitude_m = 0;
  EXPECT_EQ(other.at(10, 0), HookGuard::None);
  EXPECT_EQ(other.at(10.25), HookGuard::NearBottom);
}

TEST(HookbehGuardEdges, HalfOfTheDepthOrFiveMetresAreFar) {
  GuardBench bench(Bench::descend(29));
  bench.at(20, 4.75);
  EXPECT_EQ(bench.at(20), HookGuard::NearBottom);
  EXPECT_EQ(bench.at(10.25), HookGuard::NearBottom);
  EXPECT_EQ(bench.at(10), HookGuard::None);
  GuardBench shallow(Bench::descend(29));
  EXPECT_EQ(shallow.at(8, 4.75), HookGuard::NearBottom);
  EXPECT_EQ(shallow.at(3.25), HookGuard::NearBottom) << "half of the depth is too little";
  EXPECT_EQ(shallow.at(3), HookGuard::None);
}

TEST(HookbehGuardEdges, ADiveHasThreeMinutesForAMetreAndAClimbFour) {
  for (const auto& [way, guard, cycles] : {std::tuple{HookWay::Down, HookGuard::NoDepthGained, 181},
                                           {HookWay::Up, HookGuard::NoHeightGained, 241}}) {
    GuardBench bench;
    bench.at(10);
    bench.way = way;
    bench.step_s = 1;
    EXPECT_EQ(bench.until(guard, 10, 1e-7), cycles) << "one in which it turns";
  }
}

TEST(HookbehGuardEdges, ADepthThatIsNotKnownDoesNotCountNorDoesTheCycleAfterIt) {
  for (const double wrong : {kNan, 60.0}) {
    GuardBench bench;
    for (int i = 0; i < 20; ++i) {
      bench.at(10 + (i % 2) * 1e-7);
    }
    bench.way = HookWay::Down;
    for (int i = 0; i < 10; ++i) {
      bench.at(10 + (i % 2) * 1e-7);
    }
    EXPECT_NE(bench.cycle({wrong, 0, kNan, kNan}), HookGuard::None) << wrong;
    EXPECT_EQ(bench.until(HookGuard::NoDepthGained, 10, 1e-7), 37) << wrong;
  }
}

TEST(HookbehGuardEdges, AMetreOfHeightOrATargetBelowEndsAClimbThatGainedNone) {
  const auto stalled = [] {
    GuardBench bench(Bench::ascend(5));
    bench.at(10);
    bench.way = HookWay::Up;
    EXPECT_NE(bench.until(HookGuard::NoHeightGained, 10, 1e-7), 0);
    bench.way = HookWay::None;
    return bench;
  };
  GuardBench bench = stalled();
  EXPECT_EQ(bench.at(9.25), HookGuard::NoHeightGained);
  EXPECT_EQ(bench.at(9), HookGuard::None);
  bench = stalled();
  bench.in_force = Bench::ascend(9.5);
  EXPECT_EQ(bench.at(9.5), HookGuard::NoHeightGained);
  bench.in_force = Bench::ascend(9.75);
  EXPECT_EQ(bench.at(9.5), HookGuard::None);
}

/// One whose dive gained no depth at `depth_m`.
GuardBench idleAt(double depth_m) {
  GuardBench bench(Bench::descend(20));
  bench.depth = depth_m;
  bench.way = HookWay::Down;
  EXPECT_EQ(bench.until(HookGuard::NoDepthGained, depth_m), 46);
  bench.way = HookWay::None;
  bench.step_s = 1;
  return bench;
}

TEST(HookbehGuardEdges, AtTheSurfaceADiveIsTriedAgainAfterTenMinutesIfTheDepthLivesForOne) {
  EXPECT_EQ(idleAt(1).until(HookGuard::None, 1, 1e-7), 600);
  EXPECT_EQ(idleAt(1.25).until(HookGuard::None, 1.25, 1e-7), 0) << "no surface";
  GuardBench frozen = idleAt(1);
  for (int i = 0; i < 700; ++i) {
    EXPECT_EQ(frozen.at(1), HookGuard::NoDepthGained) << i;
  }
  EXPECT_EQ(frozen.until(HookGuard::None, 1, 1e-7), 61) << "the first is the same once more";
}

TEST(HookbehGuardEdges, FromHalfTheDepthADiveThatGainedNoneIsTriedAgainAtOnce) {
  GuardBench bench = idleAt(20);
  EXPECT_EQ(bench.at(10.25), HookGuard::NoDepthGained);
  EXPECT_EQ(bench.at(10), HookGuard::None);
}

/// Cycles of 10 s, in each of which it may drift down by a metre, until it must show its depth.
int untilItShows(const Instruction& in_force, double shown_m, bool has_moved) {
  GuardBench bench(in_force);
  bench.depth = has_moved ? shown_m - 10 : shown_m;
  bench.at(shown_m);
  bench.step_s = 10;
  bench.last = kAdrift;
  EXPECT_EQ(bench.at(shown_m), HookGuard::None) << "it may rise for 12 s";
  for (int cycles = 1; cycles <= 1000; ++cycles) {
    bench.at(shown_m);
    if (hookbehGuardMustShowDepth(&bench.guard, &bench.args, &in_force)) {
      return cycles;
    }
  }
  return 0;
}

TEST(HookbehGuardEdges, MayBeAsDeepAsItsLimitUnseen) {
  const Instruction hover = Bench::vertical(HookVertical::Hover, 10);
  EXPECT_EQ(untilItShows(hover, 20, true), 10) << "to 30 m";
  EXPECT_EQ(untilItShows(hover, 27, true), 7) << "7 m at least";
  EXPECT_EQ(untilItShows(hover, 4, true), 26);
  EXPECT_EQ(untilItShows(hover, 6, false), 20) << "before it has moved";
}

TEST(HookbehGuardEdges, MayBeEightMetresPastTheTargetOfADiveOrTenPastWhatItShowed) {
  EXPECT_EQ(untilItShows(Bench::descend(14), 8, true), 14) << "to 22 m";
  EXPECT_EQ(untilItShows(Bench::descend(8), 8, true), 10) << "to 18 m";
  EXPECT_EQ(untilItShows(Bench::ascend(14), 8, true), 22) << "no dive: to 30 m";
}

TEST(HookbehGuardEdges, OneThatHasShownItsDepthShowsItNoLonger) {
  const Instruction hover = Bench::vertical(HookVertical::Hover, 10);
  GuardBench bench(hover);
  bench.at(20);
  bench.step_s = 10;
  bench.last = kAdrift;
  for (int i = 0; i < 20; ++i) {
    bench.at(20 + i % 2 * 1e-7);
    hookbehGuardMustShowDepth(&bench.guard, &bench.args, &hover);
  }
  bench.step_s = 4;
  bench.last = kOther;
  bench.at(18.5);
  EXPECT_TRUE(hookbehGuardMustShowDepth(&bench.guard, &bench.args, &hover)) << "1.5 m are noise";
  bench.at(17);
  EXPECT_FALSE(hookbehGuardMustShowDepth(&bench.guard, &bench.args, &hover));
}

TEST(HookbehGuardEdges, ResetForgetsTheLimitThatWasExceeded) {
  GuardBench bench(Bench::descend(40));
  EXPECT_EQ(bench.at(30.25), HookGuard::TooDeep);
  EXPECT_EQ(bench.at(29.5), HookGuard::TooDeep);
  hookbehGuardReset(&bench.guard);
  EXPECT_EQ(bench.at(29.5), HookGuard::None);
}

/// Seconds of a dive from `shown_m` that is seen by the CTD alone, or by no sensor, until it ends.
int secondsOfADive(double greatest_m, double shown_m, double pitch_rad, bool ctd_sees) {
  GuardBench bench(Bench::vertical(HookVertical::Hover, shown_m));
  bench.args.greatest_depth_m = greatest_m;
  bench.depth = shown_m - 4;
  for (int i = 0; i < 30; ++i) {  // the two agree, and it has moved
    const double flicker = i % 2 * 1e-7;
    const double depth = shown_m - (i < 10 ? 4 - 0.4 * i : 0) + flicker;
    bench.cycle({depth, 0, kNan, ctd_sees ? depth : kNan});
  }
  bench.last = {pitch_rad, -230};
  bench.step_s = 1;
  for (int seconds = 1; seconds <= 1000; ++seconds) {
    const double depth = shown_m + seconds % 2 * 1e-7;
    bench.cycle({depth, 0, kNan, ctd_sees ? depth : kNan});
    if (hookbehGuardMustShowDepth(&bench.guard, &bench.args, &bench.in_force)) {
      return seconds;
    }
  }
  return 0;
}

TEST(HookbehGuardEdges, TwoSensorsMayBeWrongForElevenMetresOrAsFarAsItMayGo) {
  EXPECT_EQ(secondsOfADive(10, 8, -0.7854, true), 37) << "11 m at 0.44 m/s, once it has turned";
  EXPECT_EQ(secondsOfADive(20, 12, -0.7854, true), 51) << "16.8 m";
}

TEST(HookbehGuardEdges, ItsPitchMayBeWrongForEighteenMetres) {
  EXPECT_EQ(secondsOfADive(20, 12, -0.2, false), 53) << "18 m at 0.44 m/s";
}

TEST(HookbehGuardEdges, SaysNothingWhereItDoesNotClimb) {
  EXPECT_STREQ(wordsFor(hookClimbFor(HookGuard::None)), "");
  EXPECT_STREQ(wordsFor(hookClimbFor(HookGuard::NoHeightGained)), "climb: no height gained");
}

/// The depth stays at 10 m except in its last bits, and the CTD's increases from there.
HookGuard withACtdThat(bool moves) {
  GuardBench bench;
  HookGuard found = HookGuard::None;
  for (int i = 0; i < 40 && found == HookGuard::None; ++i) {
    const double flicker = i % 2 * 1e-7;
    found = bench.cycle({10 + flicker, 0, kNan, 20 + flicker + (moves ? i * 0.5 : 0)});
  }
  return found;
}

TEST(HookbehGuardEdges, ACtdThatMovesIsBelievedThoughItNeverAgreed) {
  EXPECT_EQ(withACtdThat(true), HookGuard::DepthsDisagree);
  EXPECT_EQ(withACtdThat(false), HookGuard::None);
}

TEST(HookbehGuardEdges, ACtdThatNeverAgreedIsNotBelievedWhereTheDepthMoves) {
  GuardBench bench;
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(bench.cycle({5 + i * 0.5, 0, kNan, 20 + i * 0.5}), HookGuard::None) << i;
  }
}

}  // namespace
}  // namespace glider::hooks
