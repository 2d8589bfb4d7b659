// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// HookDepthWatch and HookUnseenSink by themselves, at the very edges of what they believe.

#include "hooks/hookbeh/depth_watch.h"
#include "hooks/hookbeh/unseen_sink.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/begun.h"
#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <utility>

namespace glider::hooks {
namespace {

/// A watch that gets both depths. Each flickers in its last bits unless it is frozen.
struct WatchBench {
  HookGuard at(double own_m, double ctd_m = kNan, double step_s = 4) {
    flicker = flicker == 0 ? 1e-7 : 0;
    Surroundings now;
    now.depth_m = own_m + (own_frozen ? 0 : flicker);
    now.ctd_depth_m = ctd_m + (ctd_frozen ? 0 : flicker);
    hookDepthWatchObserve(&watch, &now, step_s, pump_cc);
    return hookDepthWatchDoubt(&watch);
  }
  /// A vehicle whose depths have agreed for a long time.
  static WatchBench agreed(double depth_m = 20) {
    WatchBench bench;
    for (int i = 0; i < 40; ++i) {
      EXPECT_EQ(bench.at(depth_m, depth_m), HookGuard::None);
    }
    return bench;
  }
  /// Seconds until it reports `wanted`, at most 1000, while it moves by `metres_a_second`.
  int until(HookGuard wanted, double own_m, double ctd_m = kNan, double metres_a_second = 0) {
    for (int seconds = 1; seconds <= 1000; ++seconds) {
      const double way = metres_a_second * seconds;
      if (at(own_m + way, ctd_m + way, 1) == wanted) {
        return seconds;
      }
    }
    return 0;
  }

  /// The same for two that disagree; in two steps, as one would be a jump of the CTD.
  int untilTheyDisagree(double own_m, double ctd_m) {
    at(own_m, (own_m + ctd_m) / 2, 1);
    return until(HookGuard::DepthsDisagree, own_m, ctd_m);
  }

  HookDepthWatch watch = begun(hookDepthWatchInit, &kHull);
  double pump_cc = 0;
  bool own_frozen = false, ctd_frozen = false;
  double flicker = 0;
};

TEST(HookbehDepthWatch, TwoThatDifferByMoreThanFiveMetresForTenSecondsDisagree) {
  EXPECT_EQ(WatchBench::agreed().untilTheyDisagree(20, 25.25), 10);
  EXPECT_EQ(WatchBench::agreed().untilTheyDisagree(20, 14.75), 10);
  EXPECT_EQ(WatchBench::agreed().untilTheyDisagree(20, 15.25), 0);
  WatchBench bench;
  bench.ctd_frozen = bench.own_frozen = true;
  bench.at(20, 20);
  bench.at(20, 20, 10);
  EXPECT_EQ(bench.until(HookGuard::DepthsDisagree, 20, 15), 0) << "five are few enough";
}

TEST(HookbehDepthWatch, TheCtdIsKnownOnceItHasAgreedForTenSeconds) {
  for (const double second : {4.75, 5.0}) {
    WatchBench bench;
    bench.at(20, 20, 4);
    bench.at(20, 20, second);
    EXPECT_EQ(bench.untilTheyDisagree(20, 25.5) == 10, second == 5) << second;
  }
}

TEST(HookbehDepthWatch, TwoThatDisagreeAreBelievedAfterAMinuteWhereTheyAgreeAtTheSurface) {
  WatchBench bench = WatchBench::agreed(3);
  EXPECT_EQ(bench.untilTheyDisagree(3, 8.5), 10);
  bench.pump_cc = 230;
  EXPECT_EQ(bench.until(HookGuard::None, 3, 3), 121) << "two minutes of climbing since they agree";
  bench = WatchBench::agreed(3.25);
  EXPECT_EQ(bench.untilTheyDisagree(3.25, 8.5), 10);
  bench.pump_cc = 230;
  EXPECT_EQ(bench.until(HookGuard::None, 3.25, 3.25), 0) << "no surface";
  bench = WatchBench::agreed(3);
  EXPECT_EQ(bench.untilTheyDisagree(3, 8.5), 10);
  EXPECT_EQ(bench.until(HookGuard::None, 3, 3), 0) << "nor has it climbed";
}

TEST(HookbehDepthWatch, OneThatIsStuckWhileTheVehicleIsDrivenIsFrozenAfterSixteenSeconds) {
  for (const auto& [pump, seconds] :
       {std::pair{100.0, 17}, {-100.0, 17}, {99.0, 61}, {-99.0, 61}, {kNan, 0}}) {
    WatchBench bench;
    bench.at(20);
    bench.own_frozen = true;
    bench.pump_cc = pump;
    EXPECT_EQ(bench.until(HookGuard::DepthFrozen, 20.5), seconds) << pump;
  }
  WatchBench clipped;
  clipped.own_frozen = true;
  clipped.pump_cc = 230;
  EXPECT_EQ(clipped.until(HookGuard::DepthFrozen, 1), 0) << "at the surface it may be clipped";
  EXPECT_NE(clipped.until(HookGuard::DepthFrozen, 1.25), 0);
}

TEST(HookbehDepthWatch, ADepthThatWasFrozenIsBelievedAfterAMinuteIfTheCtdAgrees) {
  WatchBench bench = WatchBench::agreed();
  bench.pump_cc = -230;
  bench.own_frozen = bench.ctd_frozen = true;
  EXPECT_NE(bench.until(HookGuard::DepthFrozen, 20, 20), 0);
  bench.own_frozen = bench.ctd_frozen = false;
  EXPECT_EQ(bench.until(HookGuard::None, 20.5, 20.5), 60);
}

TEST(HookbehDepthWatch, AFrozenDepthIsNotBelievedWhileThePumpIsUnknown) {
  WatchBench bench;
  bench.at(20);
  bench.own_frozen = true;
  bench.pump_cc = 230;
  EXPECT_NE(bench.until(HookGuard::DepthFrozen, 20), 0);
  bench.pump_cc = kNan;
  EXPECT_EQ(bench.until(HookGuard::None, 20), 0);
}

TEST(HookbehDepthWatch, AVehicleThatHangsAsTheCtdSeesIsNotFrozen) {
  const auto until_frozen = [](double ctd_m, bool ctd_frozen) {
    WatchBench bench = WatchBench::agreed();
    bench.own_frozen = true;
    bench.ctd_frozen = ctd_frozen;
    bench.pump_cc = -230;
    bench.at(20.25, 20.25, 1);
    for (int seconds = 1; seconds <= 200; ++seconds) {
      if (bench.at(20.25, ctd_m, 1) == HookGuard::DepthFrozen) {
        return seconds;
      }
    }
    return 0;
  };
  EXPECT_EQ(until_frozen(20.25, false), 0);
  EXPECT_EQ(until_frozen(20.625, false), 0);
  EXPECT_EQ(until_frozen(19.875, false), 0);
  EXPECT_EQ(until_frozen(20.875, false), 16) << "by half a metre it has moved";
  EXPECT_EQ(until_frozen(19.625, false), 16);
  EXPECT_EQ(until_frozen(20.25, true), 16) << "nor is one believed that is stuck itself";
  EXPECT_EQ(until_frozen(kNan, false), 21) << "or that has been silent for more than 20 s";
}

TEST(HookbehDepthWatch, JumpsCountForTenSecondsAndAreNotForgottenAtTheSurface) {
  WatchBench bench;
  for (int i = 0; i < 40; ++i) {
    bench.at(2);
  }
  bench.pump_cc = 230;
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(bench.at(40, kNan, 1), HookGuard::DepthJumps);
  }
  EXPECT_EQ(bench.at(2, kNan, 1), HookGuard::None) << "8.5 s of them are left";
  EXPECT_EQ(bench.at(40, kNan, 1), HookGuard::DepthJumps);
  EXPECT_EQ(bench.at(40, kNan, 1), HookGuard::DepthJumps);
  EXPECT_EQ(bench.until(HookGuard::None, 2), 0);
}

TEST(HookbehDepthWatch, TenSecondsOfJumpsAreTooMany) {
  for (const int jumps : {9, 10}) {
    WatchBench bench;
    for (int i = 0; i < 40; ++i) {
      bench.at(20);
    }
    for (int i = 0; i < jumps; ++i) {
      EXPECT_EQ(bench.at(60, kNan, 1), HookGuard::DepthJumps);
    }
    EXPECT_EQ(bench.at(20, kNan, 1) == HookGuard::None, jumps == 9);
  }
}

TEST(HookbehDepthWatch, FiveMetresApartTheyAgree) {
  WatchBench bench;
  bench.pump_cc = kNan;
  bench.own_frozen = bench.ctd_frozen = true;
  for (int i = 0; i < 40; ++i) {
    bench.at(20, 20);
  }
  bench.at(20, 22.5, 1);
  EXPECT_EQ(bench.until(HookGuard::DepthsDisagree, 20, 25), 0);
  EXPECT_EQ(bench.until(HookGuard::DepthsDisagree, 20, 25.25), 10);
}

TEST(HookbehDepthWatch, OneWhoseCtdIsHalfAMetreAwayDoesNotHang) {
  for (const double far : {0.5, 0.46875}) {
    WatchBench bench;
    bench.own_frozen = bench.ctd_frozen = true;
    for (int i = 0; i < 10; ++i) {
      bench.at(20 + i * 0.125, 20 + i * 0.125);
    }
    bench.pump_cc = -230;
    HookGuard found = HookGuard::None;
    for (int i = 0; i < 40 && found == HookGuard::None; ++i) {
      found = bench.at(21.125, 21.125 + (i % 2 == 0 ? 0.25 : far), 1);
    }
    EXPECT_EQ(found == HookGuard::DepthFrozen, far == 0.5) << far;
  }
}

/// One that was frozen at 3 m, with a CTD that agrees.
WatchBench thawedAtThree() {
  WatchBench bench = WatchBench::agreed(3);
  bench.pump_cc = -230;
  bench.own_frozen = bench.ctd_frozen = true;
  EXPECT_NE(bench.until(HookGuard::DepthFrozen, 3, 3), 0);
  bench.own_frozen = bench.ctd_frozen = false;
  bench.pump_cc = 0;
  return bench;
}

TEST(HookbehDepthWatch, AnotherFreezeOfSixteenSecondsRestartsTheMinute) {
  for (const int same : {15, 16}) {
    WatchBench bench = thawedAtThree();
    for (int i = 0; i < 20; ++i) {
      EXPECT_EQ(bench.at(2.5, 2.5, 1), HookGuard::DepthFrozen);
    }
    bench.own_frozen = true;
    for (int i = 0; i <= same; ++i) {
      EXPECT_EQ(bench.at(2.25, 2.5, 1), HookGuard::DepthFrozen);
    }
    bench.own_frozen = false;
    EXPECT_EQ(bench.until(HookGuard::None, 2.5, 2.5), same == 15 ? 60 - 20 - 16 : 60);
  }
}

TEST(HookbehDepthWatch, AtAMetreAnUnchangedDepthIsNotFrozen) {
  WatchBench bench = thawedAtThree();
  bench.own_frozen = true;
  EXPECT_EQ(bench.until(HookGuard::None, 1, 1), 60);
}

TEST(HookbehDepthWatch, TwoMinutesOfClimbingAreEnough) {
  WatchBench bench = WatchBench::agreed(2);
  EXPECT_EQ(bench.untilTheyDisagree(2, 7.5), 10);
  bench.pump_cc = 1;
  EXPECT_EQ(bench.until(HookGuard::None, 2, 2), 120);
  bench = WatchBench::agreed(2);
  EXPECT_EQ(bench.untilTheyDisagree(2, 7.5), 10);
  bench.pump_cc = 0;
  EXPECT_EQ(bench.until(HookGuard::None, 2, 2), 0) << "the pump is not out";
}

TEST(HookbehDepthWatch, ACtdThatFallsSilentHasNoLastWord) {
  WatchBench bench = WatchBench::agreed();
  bench.at(20, 22.75, 1);
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(bench.at(20, 25.5, 1), HookGuard::None);
  }
  EXPECT_EQ(bench.at(20, kNan, 1), HookGuard::None);
  EXPECT_EQ(bench.at(20, 25.5, 1), HookGuard::DepthsDisagree) << "it reports again";
}

TEST(HookbehDepthWatch, ACtdThatJumpedAndFellSilentHasNotAgreed) {
  WatchBench bench = WatchBench::agreed();
  bench.own_frozen = true;
  for (int i = 0; i < 20; ++i) {
    bench.at(20, 20);
  }
  EXPECT_GT(bench.watch.alive_s, 0);
  bench.at(20, 60, 1);
  EXPECT_EQ(bench.watch.alive_s, 0);
  bench.at(20, kNan, 1);
  EXPECT_EQ(bench.watch.alive_s, 0);
}

TEST(HookbehDepthWatch, ClimbingCountsFromWhereItThawed) {
  WatchBench bench;
  bench.at(2);
  bench.own_frozen = true;
  bench.pump_cc = -230;
  EXPECT_NE(bench.until(HookGuard::DepthFrozen, 2), 0);
  bench.pump_cc = 50;
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(bench.at(2, kNan, 1), HookGuard::DepthFrozen);
  }
  bench.own_frozen = false;
  EXPECT_EQ(bench.until(HookGuard::None, 2.5), 120);
}

TEST(HookbehDepthWatch, AnyFaultInTheMeantimeRestartsTheMinute) {
  WatchBench bench;
  bench.at(2);
  bench.own_frozen = true;
  bench.pump_cc = 230;
  EXPECT_NE(bench.until(HookGuard::DepthFrozen, 2), 0);
  bench.own_frozen = false;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(bench.at(2.5, kNan, 1), HookGuard::DepthFrozen);
  }
  EXPECT_EQ(bench.at(kNan, kNan, 1), HookGuard::DepthUnknown);
  EXPECT_EQ(bench.until(HookGuard::None, 2.5), 60);
  bench = WatchBench::agreed(2);
  EXPECT_EQ(bench.untilTheyDisagree(2, 7.5), 10);
  bench.pump_cc = 230;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(bench.at(2, 2, 1), HookGuard::DepthsDisagree);
  }
  bench.at(2, 4.75, 1);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(bench.at(2, 7.5, 1), HookGuard::DepthsDisagree);
  }
  bench.at(2, 4.75, 1);
  EXPECT_EQ(bench.until(HookGuard::None, 2, 4.75), 59) << "and the second before";
}

TEST(HookbehDepthWatch, TheCtdMustHaveAgreedForAMinute) {
  WatchBench bench = thawedAtThree();
  EXPECT_EQ(bench.until(HookGuard::None, 3.5), 0) << "no other sensor, nor has it climbed";
  EXPECT_EQ(bench.until(HookGuard::None, 3.5, 3.5), 60);
}

TEST(HookbehDepthWatch, TheDeeperCountsWhereTheCtdIsKnownAndNew) {
  WatchBench bench = WatchBench::agreed();
  bench.at(20, 22);
  EXPECT_NEAR(hookDepthWatchDeepest(&bench.watch), 22, 1e-6);
  bench.at(20, 18);
  EXPECT_NEAR(hookDepthWatchDeepest(&bench.watch), 20, 1e-6) << "the own one is deeper";
  bench.at(20, 22);
  bench.at(20, kNan);
  EXPECT_NEAR(hookDepthWatchDeepest(&bench.watch), 20, 1e-6) << "it fell silent";
  WatchBench strange;
  strange.at(20, 22);
  EXPECT_NEAR(hookDepthWatchDeepest(&strange.watch), 20, 1e-6) << "it is not known yet";
  bench = WatchBench::agreed();
  bench.at(20, 60);
  EXPECT_NEAR(hookDepthWatchDeepest(&bench.watch), 20, 1e-6) << "it jumps";
}

TEST(HookbehDepthWatch, TheCtdsDepthIsTheOneOfThisCycle) {
  WatchBench bench = WatchBench::agreed();
  bench.at(20, 21);
  EXPECT_NEAR(hookDepthWatchCtdDepth(&bench.watch), 21, 1e-6);
  bench.at(20, kNan);
  EXPECT_TRUE(std::isnan(hookDepthWatchCtdDepth(&bench.watch))) << "silent";
  bench.at(20, 60);
  EXPECT_TRUE(std::isnan(hookDepthWatchCtdDepth(&bench.watch))) << "it jumps";
}

TEST(HookbehDepthWatch, IsSeenByAnotherWhereThatIsNewAndAgrees) {
  WatchBench bench = WatchBench::agreed();
  bench.at(20, 20.5);
  EXPECT_TRUE(hookDepthWatchIsSeenByAnother(&bench.watch));
  bench.at(20, kNan);
  EXPECT_FALSE(hookDepthWatchIsSeenByAnother(&bench.watch)) << "silent";
  bench.ctd_frozen = true;
  bench.at(20, 20.5);
  bench.at(20, 20.5);
  EXPECT_FALSE(hookDepthWatchIsSeenByAnother(&bench.watch)) << "the same once more";
  bench.ctd_frozen = false;
  bench.at(20, 23.5);
  EXPECT_TRUE(hookDepthWatchIsSeenByAnother(&bench.watch));
  bench.at(20, 27);
  EXPECT_FALSE(hookDepthWatchIsSeenByAnother(&bench.watch)) << "it differs";
  bench = WatchBench::agreed();
  bench.at(kNan, 20.5);
  EXPECT_FALSE(hookDepthWatchIsSeenByAnother(&bench.watch)) << "of nothing";
}

TEST(HookbehDepthWatch, ACtdIsAvailableForTwentySecondsAfterItsLastReading) {
  for (const double silence : {20.0, 20.25}) {
    WatchBench bench = WatchBench::agreed();
    bench.own_frozen = true;
    for (int i = 0; i < 10; ++i) {
      bench.at(20, 20);
    }
    bench.at(20, kNan, silence);
    EXPECT_EQ(bench.watch.alive_s > 0, silence == 20) << "what agreed agrees on";
  }
}

TEST(HookbehDepthWatch, ADepthIsAliveWhileItChangesOrTheCtdAgrees) {
  WatchBench bench;
  bench.at(20, kNan, 4);
  EXPECT_EQ(bench.watch.alive_s, 4);
  bench.at(kNan, kNan, 4);
  EXPECT_EQ(bench.watch.alive_s, 0) << "there is no depth";
  bench.at(20, kNan, 4);
  bench.at(60, kNan, 1);
  EXPECT_EQ(bench.watch.alive_s, 0) << "it jumps";
  bench = WatchBench();
  bench.own_frozen = true;
  bench.at(20, kNan, 4);
  bench.at(20, kNan, 15.75);
  EXPECT_EQ(bench.watch.alive_s, 19.75);
  bench.at(20, kNan, 0.25);
  EXPECT_EQ(bench.watch.alive_s, 0) << "the same for 16 s";
  bench = WatchBench::agreed();
  bench.own_frozen = true;
  const double before = bench.watch.alive_s;
  for (int i = 0; i < 20; ++i) {
    bench.at(20, 20, 4);
  }
  EXPECT_EQ(bench.watch.alive_s, before + 80);
  bench.at(20, kNan, 30);
  EXPECT_EQ(bench.watch.alive_s, 0);
  bench.at(20, 20, 0.5);
  EXPECT_EQ(bench.watch.alive_s, 0.5) << "it agrees again";
}

TEST(HookbehDepthWatch, ACtdThatIsStuckWhileTheVehicleMovesIsNotUsedBeforeItMoves) {
  for (const double way : {2.75, 3.0}) {
    WatchBench bench = WatchBench::agreed();
    bench.ctd_frozen = true;
    bench.at(20, 21, 1);
    const double changed_at = 20 + bench.flicker;
    bench.own_frozen = true;
    for (int i = 0; i < 15; ++i) {
      bench.at(changed_at + way * (i + 1) / 15, 21, 1);
    }
    bench.at(changed_at + way, 21, 1);
    // Deeper than the own depth it counts, if it lives.
    const double deepest = hookDepthWatchDeepest(&bench.watch);
    EXPECT_EQ(deepest, changed_at + way) << way;
    bench.at(changed_at + way - 2.5, 21, 1);
    bench.at(changed_at + way - 2.5, 21, 1);
    EXPECT_EQ(hookDepthWatchDeepest(&bench.watch) == 21, way < 3) << way;
  }
}

constexpr VerticalCommand kClimbs{0.4, 230}, kOtherPump{0, kNan};

void driveFor(HookUnseenSink& sink, int cycles, double depth_m, const VerticalCommand& command,
              double step_s = 1) {
  for (int i = 0; i < cycles; ++i) {
    hookUnseenSinkObserve(&sink, depth_m, step_s, &command);
  }
}

TEST(UnseenSinkEdges, FromWhatPumpAndPitchItIsDriven) {
  // In 13 s it has turned; in one more it sinks as fast as it may, or drifts.
  struct Case {
    VerticalCommand command;
    double mps;
  };
  constexpr double kFlat = 0.44 * 0.3 / 0.7854;
  for (const Case& c : {Case{{0, -60}, kFlat},
                        {{0, -59.75}, 0.1},
                        {{-0.1, 0}, kFlat},
                        {{-0.09, 0}, 0.1},
                        {{0.1, 0}, 0.1},
                        {{0.1, 116.5}, kFlat},
                        {{0.1, 116}, 0.1},
                        {{0.09, 116.5}, 0.1},
                        {{-0.5, -230}, 0.44 * 0.5 / 0.7854},
                        {{0.5, 116.5}, 0.44 * 0.5 / 0.7854}}) {
    HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
    driveFor(sink, 1, 20, kOtherPump);
    driveFor(sink, 12, 20, c.command);
    EXPECT_EQ(sink.deepest_m, 20);
    driveFor(sink, 1, 20, c.command);
    EXPECT_NEAR(sink.deepest_m, 20 + c.mps, 1e-9)
        << c.command.pitch_rad << " " << c.command.pump_cc;
  }
}

TEST(UnseenSinkEdges, RisesAfterTwentySecondsAndSinksAgainAfterTwelve) {
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
  driveFor(sink, 1, 20, kOtherPump);
  driveFor(sink, 20, 20, kClimbs);
  const double before = sink.deepest_m;
  driveFor(sink, 1, 20, kClimbs);
  EXPECT_NEAR(sink.deepest_m, before - 0.1, 1e-9);
  driveFor(sink, 12, 20, {-0.5, -230});
  EXPECT_NEAR(sink.deepest_m, before - 0.1, 1e-9);
  EXPECT_EQ(sink.in_dive_m, 0);
  driveFor(sink, 1, 20, {-0.5, -230});
  EXPECT_NEAR(sink.deepest_m, before - 0.1 + 0.44 * 0.5 / 0.7854, 1e-9);
  EXPECT_NEAR(sink.in_dive_m, 0.44 * 0.5 / 0.7854, 1e-9);
  EXPECT_NEAR(sink.steeply_m, 0.44, 1e-9);
  driveFor(sink, 1, 20, {0, -230});
  EXPECT_NEAR(sink.steeply_m, 0.44, 1e-9) << "level it is not a dive";
}

/// Whether a depth that has stood at 20 m, not driven by anything, is shown at `depth_m` so long
/// after.
bool showsAt(double depth_m, double gap_s, double middle_m = kNan) {
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
  for (int i = 0; i < 13; ++i) {
    hookUnseenSinkObserve(&sink, 20 + i % 2 * 1e-9, 1, &kOtherPump);
  }
  hookUnseenSinkObserve(&sink, middle_m, gap_s / 2, &kOtherPump);
  hookUnseenSinkObserve(&sink, depth_m, gap_s / 2, &kOtherPump);
  return sink.has_moved;
}

TEST(UnseenSinkEdges, MovesByTwoAndAHalfMetresAsFastAsAVehicle) {
  EXPECT_TRUE(showsAt(22.5, 8));
  EXPECT_FALSE(showsAt(22.25, 8));
  EXPECT_TRUE(showsAt(17.5, 8));
  EXPECT_FALSE(showsAt(17.75, 8));
  EXPECT_TRUE(showsAt(24, 8)) << "3.52 m, and half a metre of noise";
  EXPECT_FALSE(showsAt(24.25, 8)) << "a step that no vehicle makes";
  EXPECT_TRUE(showsAt(16, 8));
  EXPECT_FALSE(showsAt(15.75, 8));
  EXPECT_TRUE(showsAt(23, 20));
  EXPECT_FALSE(showsAt(23, 20.25)) << "it was not there for longer than 20 s";
}

TEST(UnseenSinkEdges, DrivenUpForTwelveSecondsItMayRise) {
  for (const int seconds : {11, 12}) {
    HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
    driveFor(sink, 5, 20, kOtherPump);
    driveFor(sink, seconds - 3, 20, kClimbs);
    for (const double depth : {19.25, 18.375, 17.5}) {
      driveFor(sink, 1, depth, kClimbs);
    }
    EXPECT_EQ(sink.has_moved, seconds == 12) << seconds;
  }
}

}  // namespace
}  // namespace glider::hooks
