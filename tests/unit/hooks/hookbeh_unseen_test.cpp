// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A vehicle that sinks while its depth does not show it, on a vehicle without a CTD or with one
// that is late or falls silent.

#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/recent_depths.h"
#include "hooks/hookbeh/unseen_sink.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/begun.h"
#include "tests/unit/hooks/hookbeh_sea.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <deque>
#include <string>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

/// A vehicle as fast as one at the pitch of the bench's instructions.
struct SlowSea : HookbehSea {
  explicit SlowSea(double greatest = 30) : HookbehSea(greatest) { full_mps = 0.2; }
};

/// Gives these depths in turn, over and over.
template <size_t kCount>
auto pattern(const std::array<double, kCount>& depths) {
  return [depths, next = size_t{0}](HookbehInputs& in) mutable {
    in.depth_m = depths.at(next++ % kCount);
  };
}

void hoverAt(HookbehSea& sea, double depth) {
  sea.diveTo(depth - 2, depth);
  sea.bench.write(Bench::vertical(HookVertical::Hover, depth));
  sea.run(20, kNothing);
  ASSERT_STREQ(wordsFor(sea.out.doing), "hover");
}

TEST(HookbehUnseen, AHoverWhoseDepthFlickersAboveItClimbsInTime) {
  for (const double stuck : {15.0, 17.0, 18.4, 19.9}) {
    SlowSea sea;
    hoverAt(sea, 20);
    sea.run(2000, [&, flick = 0.005](HookbehInputs& in) mutable {
      flick = -flick;
      in.depth_m = stuck + flick;
      sea.truth += 0.1;  // and the vehicle is heavy
    });
    EXPECT_LT(sea.deepest, 40) << stuck;
  }
}

/// Stuck, and wavering slowly: it confirms the same metres again and again.
TEST(HookbehUnseen, AHoverWhoseDepthWaversSlowlyClimbsInTime) {
  for (const double wide : {1.3, 1.5, 2.0}) {
    for (const double period : {40.0, 60.0, 100.0}) {
      for (const bool steps : {false, true}) {
        SlowSea sea;
        hoverAt(sea, 20);
        double time = 0;
        sea.run(3600, [&](HookbehInputs& in) {
          time += 4;
          const double phase = std::sin(2 * M_PI * time / period);
          in.depth_m = 20 + wide * (steps ? std::copysign(1, phase) : phase) + 1e-4 * sea.noise;
          sea.truth += sea.pump > -100 && sea.pump < 100 ? 0.36 : 0;  // and the vehicle is heavy
        });
        EXPECT_LT(sea.deepest, 55) << wide << " m in " << period << " s";
      }
    }
  }
}

TEST(HookbehUnseen, ADiveWhoseDepthWaversSlowlyTurnsInTime) {
  HookbehArgs args = HookbehSea::args(30);
  args.steepest_pitch_rad = 0.7854;
  Instruction steep = Bench::take(28);
  steep.pitch_rad = -0.785;
  for (const double wide : {1.3, 1.5, 2.0}) {
    for (const double period : {40.0, 60.0}) {
      SlowSea sea;
      sea.bench.hookbeh = Hookbeh(args, kHull);
      sea.full_mps = 0.35;
      sea.cycle();
      sea.bench.write(steep);
      while (sea.truth < 10) {
        sea.cycle();
      }
      double time = 0;
      sea.run(1800, [&](HookbehInputs& in) {
        time += 4;
        in.depth_m = 10 + wide * std::sin(2 * M_PI * time / period) + 1e-4 * sea.noise;
      });
      EXPECT_LT(sea.deepest, 50) << wide << " m in " << period << " s";
    }
  }
}

TEST(HookbehUnseen, AHoverShowsThatItsDepthLivesByAShortClimb) {
  SlowSea sea;
  hoverAt(sea, 20);
  sea.held = true;
  int cycles = 0;
  while (sea.cycle().doing == Doing::Hover && cycles < 500) {
    ++cycles;
  }
  EXPECT_STREQ(wordsFor(sea.out.doing), "check depth");
  EXPECT_EQ(sea.out.guard, HookGuard::None) << "it is not a guard";
  EXPECT_GE(cycles + 20, 22) << "10 m at 0.1 m/s, from where it came to rest";
  EXPECT_LE(cycles + 20, 30);
  sea.held = false;
  double highest = 100;
  for (int i = 0; i < 20; ++i) {
    sea.cycle();
    highest = std::min(highest, sea.truth);
    EXPECT_STRNE(wordsFor(sea.out.doing), "dive_to") << "its pump brings it back";
  }
  EXPECT_STREQ(wordsFor(sea.out.doing), "hover") << "it goes on";
  EXPECT_LT(highest, 19);
  EXPECT_NEAR(sea.truth, 20, 4);
}

/// What the vehicle may have sunk in the hover does not count as a dive that gains no depth.
TEST(HookbehUnseen, ADiveAfterALongHoverMayShowThatItsDepthLivesFirst) {
  int checks = 0;
  for (int waits = 0; waits < 30; ++waits) {
    SlowSea sea(60);
    hoverAt(sea, 20);
    sea.held = true;
    sea.run(waits, kNothing);
    sea.held = false;
    sea.bench.write(Bench::descend(22));
    for (int i = 0; i < 60; ++i) {
      ASSERT_EQ(sea.cycle().guard, HookGuard::None) << waits << " " << i;
      checks += sea.out.doing == Doing::CheckDepth ? 1 : 0;
    }
    EXPECT_NEAR(sea.truth, 22, 3) << waits;
  }
  EXPECT_GT(checks, 0);
}

TEST(HookbehUnseen, AHoverThatTheCtdSeesShowsItsDepthByAShortClimbEveryFewMinutes) {
  SlowSea sea;
  sea.has_ctd = true;
  hoverAt(sea, 20);
  int climbs = 0, climbing = 0;
  double highest = 20;
  for (int i = 0; i < 900; ++i) {  // an hour
    const bool climbed = sea.out.doing == Doing::CheckDepth;
    sea.cycle();
    const bool climbs_now = sea.out.doing == Doing::CheckDepth;
    climbs += climbs_now && !climbed;
    climbing += climbs_now;
    highest = std::min(highest, sea.truth);
    ASSERT_EQ(sea.out.guard, HookGuard::None) << i;
  }
  EXPECT_GE(climbs, 7);
  EXPECT_LE(climbs, 12) << "300 s apart";
  EXPECT_LE(climbing, 11 * climbs) << "44 s each";
  EXPECT_GT(highest, 12);
}

TEST(HookbehUnseen, AHoverWhoseDepthAndCtdAreStuckAndFlickerComesUp) {
  for (const double by : {0.02, 0.3, 0.8, 1.2}) {
    for (const double heavy : {0.0, 0.03, 0.05}) {
      SlowSea sea(60);
      sea.has_ctd = true;
      hoverAt(sea, 50);
      double flick = 0.9;  // chaotic, and the same in each run
      const auto stuck = [&](HookbehInputs& in) {
        flick = 3.99 * flick * (1 - flick);
        in.depth_m = 50 + by * (2 * flick - 1);
        in.ctd_bar = (50 + by * (1 - 2 * flick)) / 10;
        sea.truth += heavy * 4;
      };
      sea.until(HookGuard::NoDepthGained, stuck);
      EXPECT_EQ(sea.out.guard, HookGuard::NoDepthGained) << by << " " << heavy;
      EXPECT_LT(sea.deepest, 50 + 25) << by << " " << heavy;
      sea.run(150, stuck);
      EXPECT_LT(sea.truth, 5) << "it comes up";
      sea.run(2000, stuck);
      EXPECT_LT(sea.deepest, 50 + 25) << "and does not sink again";
    }
  }
}

/// A hover at 2 m cannot climb by 2.5 m: the surface is an answer too.
TEST(HookbehUnseen, AShallowHoverShowsItsDepthAtTheSurface) {
  SlowSea sea(60);
  sea.has_ctd = true;
  hoverAt(sea, 2.5);
  int climbing = 0;
  for (int i = 0; i < 900; ++i) {
    sea.cycle();
    climbing += sea.out.doing == Doing::CheckDepth;
    ASSERT_EQ(sea.out.guard, HookGuard::None) << i;
  }
  EXPECT_GT(climbing, 0);
  EXPECT_LT(climbing, 200);
}

TEST(HookbehUnseen, ADiveWhoseDepthFlickersEndsInTime) {
  const std::array<std::array<double, 4>, 4> patterns = {{{20, 20.01, 20, kNan},
                                                          {20, 20.01, 20, 45},
                                                          {20, kNan, 20.01, kNan},
                                                          {20, 20.7, 19.6, 20.3}}};
  for (const auto& depths : patterns) {
    SlowSea sea;
    sea.diveTo(20, 28);
    auto stuck = pattern(depths);
    sea.run(2000, stuck);
    EXPECT_LT(sea.deepest, 40) << depths[3];
  }
}

TEST(HookbehUnseen, ASteepDiveWhoseDepthIsStuckNearTheSurfaceEndsInTime) {
  for (const double stuck : {0.0, 0.3, 1.0}) {
    HookbehArgs args = HookbehSea::args(30);
    args.steepest_pitch_rad = 0.7854;
    HookbehSea sea;
    sea.bench.hookbeh = Hookbeh(args, kHull);
    sea.full_mps = 0.4;
    sea.cycle();
    Instruction take = Bench::take(28);
    take.pitch_rad = -0.785;
    sea.bench.write(take);
    sea.run(1000, [=](HookbehInputs& in) { in.depth_m = stuck; });
    EXPECT_LT(sea.deepest, 38) << stuck;
    EXPECT_LT(sea.truth, 1) << stuck;
  }
}

TEST(HookbehUnseen, AHoverThatIsCommandedInEachCycleStillChecksItsDepth) {
  SlowSea sea;
  hoverAt(sea, 20);
  for (int i = 0; i < 1000; ++i) {
    sea.bench.write(Bench::vertical(HookVertical::Hover, 20 + 0.5 * (i % 2)));
    sea.cycle([&](HookbehInputs& in) {
      in.depth_m = 20 + 0.01 * (i % 2);
      sea.truth += 0.1;
    });
  }
  EXPECT_LT(sea.deepest, 40);
}

TEST(HookbehUnseen, WhatAnotherBehaviourFliesDoesNotCount) {
  SlowSea sea;
  sea.diveTo(5, 28);
  for (int i = 0; i < 200; ++i) {  // a behaviour above it keeps the vehicle at the surface
    sea.pump = 230;
    sea.cycle([](HookbehInputs& in) { in.commanded_pump_cc = 230; });
    ASSERT_EQ(sea.out.guard, HookGuard::None) << i;
    ASSERT_STREQ(wordsFor(sea.out.doing), "dive_to") << i;
  }
}

TEST(HookbehUnseen, AGuardClimbsWithAllOfTheHullsPump) {
  HookbehArgs args = HookbehSea::args(30);
  args.climb_pump_cc = 130;
  HookbehSea sea;
  sea.bench.hookbeh = Hookbeh(args, kHull);
  sea.cycle();
  sea.diveTo(20, 28);
  sea.cycle([](HookbehInputs& in) { in.depth_m = kNan; });
  EXPECT_EQ(sea.out.pump_cc, kHull.pump_cc);
  sea.bench.write(Bench::ascend(5));
  sea.run(2, kNothing);
  EXPECT_EQ(sea.out.pump_cc, 130) << "a climb that was instructed";
}

TEST(HookbehUnseen, ADiveThatMayBeFarPastItsTargetEndsThoughItsLimitIsFar) {
  SlowSea sea(150);
  sea.diveTo(20, 30);
  auto stuck = pattern(std::array<double, 2>{20, 20.01});
  sea.until(HookGuard::NoDepthGained, stuck);
  EXPECT_LT(sea.deepest, 38);
}

TEST(HookbehUnseen, CommandsToClimbInBetweenDoNotHideAStuckDepth) {
  SlowSea sea;
  sea.diveTo(20, 28);
  for (int i = 0; i < 300; ++i) {
    sea.bench.write(i % 4 == 3 ? Bench::ascend(5) : Bench::descend(28));
    sea.cycle([i](HookbehInputs& in) { in.depth_m = 20 + 0.01 * (i % 2); });
  }
  EXPECT_LT(sea.deepest, 40);
}

TEST(HookbehUnseen, ANewSessionKeepsThatNoDepthWasGained) {
  SlowSea sea;
  sea.diveTo(20, 28);
  auto flicker = [flick = 0.005](HookbehInputs& in) mutable {
    flick = -flick;
    in.depth_m = 20 + flick;
  };
  for (uint32_t session = 2; session < 30; ++session) {
    sea.run(25, flicker);
    sea.bench.alive = false;
    sea.run(8, flicker);
    ASSERT_EQ(sea.out.state, HookState::Silent);
    sea.bench.alive = true;
    sea.bench.write(Bench::take(28, session));
  }
  EXPECT_LT(sea.deepest, 40);
}

TEST(HookbehUnseen, ANewSessionDoesNotClearNoDepthGained) {
  SlowSea sea;
  sea.diveTo(20, 28);
  auto flicker = pattern(std::array<double, 2>{20, 20.01});
  sea.until(HookGuard::NoDepthGained, flicker);
  sea.bench.alive = false;
  sea.run(8, flicker);
  ASSERT_EQ(sea.out.state, HookState::Silent);
  sea.bench.alive = true;
  sea.bench.write(Bench::take(28, 2));
  sea.cycle(flicker);
  EXPECT_EQ(sea.out.state, HookState::Active);
  EXPECT_EQ(sea.out.guard, HookGuard::NoDepthGained);
}

/// A steep dive to 50 m whose CTD is spoiled in a way that does not call for a climb.
template <typename Spoil>
void expectNoGuard(Spoil&& spoil) {
  HookbehSea sea;
  sea.full_mps = 0.4;
  sea.has_ctd = true;
  sea.diveTo(15, 55);
  for (int i = 0; i < 100 && sea.truth < 52; ++i) {
    sea.cycle(spoil);
    ASSERT_EQ(sea.out.guard, HookGuard::None) << sea.truth;
  }
  ASSERT_GT(sea.truth, 51);
}

TEST(HookbehCtd, ACtdThatFallsSilentDoesNotDisagree) {
  expectNoGuard([](HookbehInputs& in) { in.ctd_bar = kNan; });
}

TEST(HookbehCtd, ACtdThatReportsSeldomAndAgreesIsAccepted) {
  for (const int every : {2, 5, 10}) {
    expectNoGuard([every, i = 0](HookbehInputs& in) mutable {
      in.ctd_bar = i++ % every == 0 ? in.ctd_bar : kNan;
    });
  }
}

TEST(HookbehCtd, ALateCtdDoesNotDisagree) {
  for (const size_t late : {1U, 3U, 4U}) {  // cycles of 4 s
    expectNoGuard([late, past = std::deque<double>()](HookbehInputs& in) mutable {
      past.push_back(in.ctd_bar);
      in.ctd_bar = past.at(past.size() - 1 - std::min(late, past.size() - 1));
    });
  }
}

TEST(HookbehCtd, ACtdThatJumpsIsIgnoredUntilItAgreesAgain) {
  HookbehSea sea;
  sea.has_ctd = true;
  hoverAt(sea, 30);
  double flick = 0.001;
  for (int i = 0; i < 100; ++i) {
    sea.cycle([&](HookbehInputs& in) { in.ctd_bar = 5.6 + (flick = -flick); });
    ASSERT_EQ(sea.out.guard, HookGuard::None) << i;
  }
  sea.run(5, kNothing);
  auto drifts = [off = 0.0](HookbehInputs& in) mutable { in.ctd_bar -= (off += 0.03); };
  EXPECT_LT(sea.until(HookGuard::DepthsDisagree, drifts), 40) << "it agreed again";
}

TEST(HookbehCtd, AMovingCtdIsBelievedIfTheDepthHasNeverMoved) {
  HookbehSea sea;
  sea.has_ctd = true;
  const auto stuck = [](HookbehInputs& in) {
    in.depth_m = 28.5 + (in.depth_m - std::floor(in.depth_m)) / 100;
  };
  sea.run(5, stuck);
  sea.take(50);
  EXPECT_LT(sea.until(HookGuard::DepthsDisagree, stuck), 20);
  EXPECT_LT(sea.deepest, 15);
}

TEST(HookbehCtd, ACtdThatReportsSeldomCanDisagree) {
  HookbehSea sea;
  sea.has_ctd = true;
  sea.diveTo(20, 58);
  int i = 0;
  const auto scaled = [&](HookbehInputs& in) {
    in.depth_m *= 0.7;
    in.ctd_bar = i++ % 4 == 0 ? in.ctd_bar : kNan;
  };
  sea.until(HookGuard::DepthsDisagree, scaled);
  EXPECT_EQ(sea.out.guard, HookGuard::DepthsDisagree);
  EXPECT_LT(sea.deepest, 60);
}

TEST(HookbehCtd, AStuckCtdIsNotAliveWhenTheVehiclePassesItsDepth) {
  HookbehSea sea;
  sea.has_ctd = true;
  sea.diveTo(20, 50);
  const double stuck = sea.bench.inputs.ctd_bar;
  const auto freeze = [=](HookbehInputs& in) { in.ctd_bar = stuck; };
  sea.run(60, freeze);
  sea.bench.write(Bench::ascend(5));
  for (int i = 0; i < 60 && sea.truth > 7; ++i) {
    sea.cycle(freeze);
    ASSERT_EQ(sea.out.guard, HookGuard::None) << sea.truth;
  }
  sea.bench.write(Bench::descend(50));
  for (int i = 0; i < 60; ++i) {
    sea.cycle(freeze);
    ASSERT_EQ(sea.out.guard, HookGuard::None) << sea.truth;
  }
}

TEST(HookbehCtd, AnOldDeeperCtdReadingDoesNotKeepTheVehicleUp) {
  HookbehSea sea(30);
  sea.has_ctd = true;
  sea.diveTo(27.5, 29);
  sea.cycle([](HookbehInputs& in) { in.ctd_bar += 0.28; });  // then silence
  ASSERT_EQ(sea.out.guard, HookGuard::TooDeep);
  const auto silent = [](HookbehInputs& in) { in.ctd_bar = kNan; };
  sea.bench.write(Bench::ascend(5));
  EXPECT_LE(sea.until(HookGuard::None, silent), 2) << "by the depth that is new";
}

TEST(HookbehDepthSource, WhatASensorSaysInItsFirstSecondsDoesNotCount) {
  HookbehSea sea;
  sea.run(2, [](HookbehInputs& in) { in.depth_m = 25; });
  sea.take(20);
  sea.run(30, kNothing);
  EXPECT_EQ(sea.out.guard, HookGuard::None);
  EXPECT_GT(sea.truth, 10);
}

TEST(HookbehDepthSource, GoodReadingsInBetweenDoNotHideOneThatJumps) {
  HookbehSea sea;
  sea.diveTo(20, 50);
  sea.run(40, [i = 0](HookbehInputs& in) mutable { in.depth_m += i++ % 2 == 0 ? 20 : 0; });
  sea.run(10, kNothing);
  EXPECT_EQ(sea.out.guard, HookGuard::DepthJumps) << "half of them: it is broken";
}

TEST(RecentDepths, HoldsWhatWasWithinTwentySeconds) {
  HookRecentDepths recent = begun(hookRecentDepthsInit);
  EXPECT_TRUE(std::isnan(hookRecentDepthsDistanceTo(&recent, 10)));
  for (const double depth : {10.0, 12.0, kNan, 11.0}) {
    hookRecentDepthsObserve(&recent, depth, 4);
  }
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 10), 0);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 9), 1);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 15), 3);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 11.3), 0);
  hookRecentDepthsObserve(&recent, 11, 10);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 10), 1) << "the 10 m are 22 s old";
  hookRecentDepthsObserve(&recent, 30, 100);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 12), 18);
}

constexpr VerticalCommand kDown{-0.4, -230}, kSteepDown{-0.7854, -230}, kUp{0.4, 230},
    kCentred{0, 0}, kUncommanded{0, kNan};

/// `cycles` of 4 s in which this was commanded.
void drive(HookUnseenSink& sink, int cycles, double depth_m, const VerticalCommand& command) {
  for (int i = 0; i < cycles; ++i) {
    hookUnseenSinkObserve(&sink, depth_m, 4, &command);
  }
}

/// One that has stood at 20 m while the vehicle turned to what is `commanded`.
HookUnseenSink stoodAt20(const VerticalCommand& commanded) {
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
  drive(sink, 20, 20, commanded);
  return sink;
}

TEST(UnseenSink, AssumesTheRateAtWhichTheVehicleSinks) {
  HookUnseenSink sink = stoodAt20(kUncommanded);
  EXPECT_EQ(sink.deepest_m, 20);
  drive(sink, 3, 20, kSteepDown);
  EXPECT_EQ(sink.deepest_m, 20) << "it has not turned yet";
  drive(sink, 10, 20, kSteepDown);
  EXPECT_NEAR(sink.deepest_m, 20 + 40 * 0.44, 1e-9) << "0.44 m/s at 45 degrees";
  const double before = sink.deepest_m;
  drive(sink, 10, 20, kCentred);
  EXPECT_NEAR(sink.deepest_m, before + 4, 1e-9) << "0.1 m/s adrift";
  drive(sink, 10, 20, {0, -61});
  EXPECT_NEAR(sink.deepest_m, before + 4 + 40 * 0.44 * 0.3 / 0.7854, 1e-9) << "flat";
  EXPECT_EQ(sink.shown_m, 20);
  EXPECT_FALSE(sink.has_moved);
}

TEST(UnseenSink, ADiveSinksWithAnyPump) {
  HookUnseenSink sink = stoodAt20(kUncommanded);
  drive(sink, 13, 20, {-0.7854, -30});
  EXPECT_NEAR(sink.deepest_m, 20 + 40 * 0.44, 1e-9);
}

TEST(UnseenSink, TakesNothingBackBeforeTheVehicleRisesAndThenLittle) {
  HookUnseenSink sink = stoodAt20(kSteepDown);
  const double before = sink.deepest_m;
  drive(sink, 5, 20, {0.7854, 230});
  EXPECT_NEAR(sink.deepest_m, before + 20 * 0.44, 1e-9) << "20 s in which the pump goes out";
  drive(sink, 10, 20, {0.7854, 230});
  EXPECT_NEAR(sink.deepest_m, before + 20 * 0.44 - 4, 1e-9) << "0.1 m/s";
  drive(sink, 1000, 20, {0.7854, 230});
  EXPECT_EQ(sink.deepest_m, 0) << "no higher than the surface";
}

TEST(UnseenSink, AWeakPumpOrALevelPitchDoesNotLift) {
  for (const VerticalCommand& weak : {VerticalCommand{0.4, 110}, {0, 230}}) {
    HookUnseenSink sink = stoodAt20(kCentred);
    const double before = sink.deepest_m;
    drive(sink, 20, 20, weak);
    EXPECT_GT(sink.deepest_m, before) << weak.pump_cc;
  }
}

TEST(UnseenSink, OtherBehavioursLeaveItAsItIsAndUnknownDepthsDoNot) {
  HookUnseenSink sink = stoodAt20(kDown);
  const double before = sink.deepest_m;
  drive(sink, 10, 20.5, kUncommanded);
  EXPECT_EQ(sink.deepest_m, before);
  drive(sink, 1, kNan, kDown);
  EXPECT_GT(sink.deepest_m, before);
}

TEST(UnseenSink, ADepthThatMovesAsTheVehicleIsDrivenIsShown) {
  struct Case {
    VerticalCommand command;
    double mps;
    bool shows;
  };
  for (const Case& c : {Case{kDown, 0.2, true},
                        {kDown, -0.2, false},
                        {kUp, -0.2, true},
                        {kUp, 0.2, false},
                        {kCentred, 0.1, true},
                        {kCentred, -0.1, true},
                        {kDown, 0.01, false},
                        {kUncommanded, 0.2, true}}) {
    HookUnseenSink sink = stoodAt20(c.command);
    double depth = 20;
    for (int i = 0; i < 10; ++i) {
      hookUnseenSinkObserve(&sink, depth += 4 * c.mps, 4, &c.command);
    }
    EXPECT_EQ(sink.has_moved, c.shows) << c.command.pump_cc << " " << c.mps;
    EXPECT_EQ(sink.shown_m != 20, c.shows) << c.command.pump_cc << " " << c.mps;
    if (c.shows) {
      EXPECT_NEAR(sink.deepest_m, depth, 5) << c.command.pump_cc << " " << c.mps;
    }
  }
}

TEST(UnseenSink, WhatFlickersSwapsOrIsRoughShowsNothing) {
  constexpr auto kFlicker = [](int i) { return i % 3 - 1; };
  for (const double by : {0.01, 0.5, 1.1, 1.4, 2.2, 5.0}) {
    for (const VerticalCommand& command : {kDown, kCentred}) {
      HookUnseenSink sink = stoodAt20(command);
      for (int i = 0; i < 200; ++i) {
        hookUnseenSinkObserve(&sink, 20 + by * kFlicker(i), 4, &command);
      }
      // Before it is known to be rough, its first readings may count.
      EXPECT_GT(sink.deepest_m, 20 + 190 * 4 * 0.1) << by;
    }
  }
  for (const int cycles : {3, 10, 40}) {
    HookUnseenSink sink = stoodAt20(kCentred);
    for (int i = 0; i < 400; ++i) {
      hookUnseenSinkObserve(&sink, 20 + 3 * (i / cycles % 2), 4, &kCentred);
    }
    EXPECT_FALSE(sink.has_moved) << "3 m back and forth, each " << cycles << " cycles";
  }
}

TEST(UnseenSink, WhatComesBackElsewhereAfterAGapShowsNothing) {
  for (const int gap : {6, 40}) {
    HookUnseenSink sink = stoodAt20(kUp);
    drive(sink, gap, kNan, kUp);
    drive(sink, 20, 12, kUp);
    EXPECT_FALSE(sink.has_moved) << gap;
  }
}

TEST(UnseenSink, AnotherSensorsWordCountsButNotForOneDive) {
  HookUnseenSink sink = stoodAt20(kDown);
  const double in_dive = sink.in_dive_m;
  EXPECT_NEAR(in_dive, (20 - 3) * 4 * 0.44 * 0.4 / 0.7854, 1e-9);
  EXPECT_NEAR(sink.steeply_m, (20 - 3) * 4 * 0.44, 1e-9) << "its pitch may be wrong";
  hookUnseenSinkConfirm(&sink, 21);
  EXPECT_EQ(sink.deepest_m, 21);
  EXPECT_FALSE(sink.has_moved);
  EXPECT_EQ(sink.in_dive_m, in_dive);
  EXPECT_EQ(sink.steeply_m, 0);
  drive(sink, 1, 20, kDown);
  EXPECT_GT(sink.steeply_m, 0);
  HookUnseenSink other = sink;
  drive(sink, 6, 20, kUp);
  EXPECT_EQ(sink.in_dive_m, 0) << "another dive";
  EXPECT_EQ(sink.steeply_m, 0);
  drive(other, 1, 20, kUncommanded);
  EXPECT_EQ(other.in_dive_m, 0) << "another behaviour's";
}

}  // namespace
}  // namespace glider::hooks
