// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Where exactly each limit of HookDepthWatch lies, in cycles of a second.

#include "hooks/hookbeh/depth_watch.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/begun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glider::hooks {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr double kIn = -230, kOut = 230, kTrims = 50;

/// Two sensors that the test reads out to a DepthWatch. Each flickers, so that no two of its
/// readings are the same, unless it is stuck.
class Sensors {
 public:
  double own_m = 20, ctd_m = kMissing, pump_cc = 0, step_s = 1;
  bool own_still = false, ctd_still = false;

  HookGuard run(int cycles = 1) {
    for (int i = 0; i < cycles; ++i) {
      flicker_ = -flicker_;
      Surroundings now;
      now.depth_m = own_m - (own_still || flicker_ < 0 ? 0 : kFlicker);
      now.ctd_depth_m = ctd_m - (ctd_still || flicker_ < 0 ? 0 : kFlicker);
      hookDepthWatchObserve(&watch, &now, step_s, pump_cc);
    }
    return hookDepthWatchDoubt(&watch);
  }
  /// Until there is no doubt; how many cycles that took, at most 1000.
  int untilNoDoubt() {
    int cycles = 1;
    while (run() != HookGuard::None && cycles < 1000) {
      ++cycles;
    }
    return cycles;
  }
  HookDepthWatch watch = begun(hookDepthWatchInit, &kHull);

 private:
  static constexpr double kFlicker = 1.0 / 1024;
  double flicker_ = 1;
};

Sensors sea(double ctd_m = kMissing) {
  Sensors sensors;
  sensors.ctd_m = ctd_m;
  sensors.run(100);
  return sensors;
}

/// Cycles from the first reading that stays until it is frozen.
int untilFrozen(Sensors sensors, double pump_cc) {
  sensors.pump_cc = pump_cc;
  sensors.own_still = true;
  sensors.own_m += 0.01;
  int cycles = -1;  // the first is not the same as anything
  while (sensors.run() == HookGuard::None && cycles < 200) {
    ++cycles;
  }
  return cycles + 1;
}

TEST(DepthWatchEdges, FrozenAfterSixteenSecondsDrivenAndSixtyInHover) {
  EXPECT_EQ(untilFrozen(sea(), 100), 16);
  EXPECT_EQ(untilFrozen(sea(), -100), 16);
  EXPECT_EQ(untilFrozen(sea(), 99.9), 60);
  EXPECT_EQ(untilFrozen(sea(), -99.9), 60);
  EXPECT_EQ(untilFrozen(sea(), kMissing), 201) << "another behaviour's";
}

TEST(DepthWatchEdges, AboveAMetreAnUnchangedDepthIsNotFrozen) {
  Sensors sensors;
  sensors.own_m = 0.99;  // and 0.01 more
  sensors.run(2);
  EXPECT_EQ(untilFrozen(sensors, kIn), 201);
  sensors.own_m = 0.992;
  EXPECT_EQ(untilFrozen(sensors, kIn), 16);
}

TEST(DepthWatchEdges, AVehicleHangsWhereTheCtdMovesByLessThanHalfAMetre) {
  for (const double moves : {0.49, 0.5}) {
    Sensors sensors = sea(20);
    sensors.own_still = true;
    sensors.pump_cc = kIn;
    sensors.own_m = 20.25;
    sensors.run(2);
    // From where the CTD was in the cycle in which the depth changed last.
    sensors.ctd_m += moves + (moves == 0.5 ? 0 : 0.001);
    sensors.run(13);
    EXPECT_EQ(sensors.run(), HookGuard::None);
    sensors.ctd_still = true;
    sensors.ctd_m = 20 + moves;
    EXPECT_EQ(sensors.run(), moves < 0.5 ? HookGuard::None : HookGuard::DepthFrozen) << moves;
  }
}

TEST(DepthWatchEdges, BothFrozenAtOnceIsFrozen) {
  Sensors sensors = sea(20);
  sensors.ctd_still = true;
  sensors.ctd_m = 20.01;
  EXPECT_EQ(untilFrozen(sensors, kIn), 16);
}

TEST(DepthWatchEdges, ACtdThatJumpedAwaySeesNoVehicleHang) {
  Sensors sensors = sea(20);
  sensors.ctd_m = 60;
  EXPECT_EQ(untilFrozen(sensors, kIn), 16);
}

TEST(DepthWatchEdges, ACtdThatFallsSilentCountsForTwentySeconds) {
  Sensors sensors = sea(20);
  sensors.ctd_m = kMissing;
  EXPECT_EQ(untilFrozen(sensors, kIn), 20)
      << "its last word was a cycle before the first that stays";
}

TEST(DepthWatchEdges, ACtdThatJumpedIsNotTrustedBeforeItIsThereAgain) {
  Sensors sensors = sea(20);
  sensors.ctd_m = 60;
  sensors.run();
  sensors.ctd_m = kMissing;
  EXPECT_EQ(untilFrozen(sensors, kIn), 16);
}

TEST(DepthWatchEdges, WithoutACtdNothingAgrees) {
  Sensors sensors;
  sensors.own_m = 0.5;
  sensors.own_still = true;
  sensors.run(16);
  EXPECT_EQ(sensors.watch.alive_s, 16);
  sensors.run();
  EXPECT_EQ(sensors.watch.alive_s, 0) << "the same for 16 s";
}

/// A CTD that is 4 m deeper than the depth, has agreed and is then stuck.
Sensors withCtdStuckBelow() {
  Sensors sensors = sea(24);
  sensors.ctd_still = true;
  sensors.ctd_m = 24.01;
  sensors.own_still = true;
  sensors.run();
  EXPECT_EQ(hookDepthWatchDeepest(&sensors.watch), 24.01);
  return sensors;
}

TEST(DepthWatchEdges, ACtdIsFrozenAfterSixteenSecondsInWhichTheDepthMovedByThreeMetres) {
  Sensors sensors = withCtdStuckBelow();
  sensors.own_m = 22.9;  // within reach of the CTD
  sensors.run(15);
  EXPECT_EQ(hookDepthWatchDeepest(&sensors.watch), 24.01) << "moved by less";
  sensors.run(10);
  EXPECT_EQ(hookDepthWatchDeepest(&sensors.watch), 24.01);
  sensors.own_m = 23;
  sensors.run();
  EXPECT_EQ(hookDepthWatchDeepest(&sensors.watch), 23) << "by 3 m";
  sensors.own_m = 20.5;
  sensors.run();
  EXPECT_EQ(hookDepthWatchDeepest(&sensors.watch), 20.5) << "until it moves";
  sensors.ctd_m = 24.02;
  sensors.run();
  EXPECT_EQ(hookDepthWatchDeepest(&sensors.watch), 24.02);
}

TEST(DepthWatchEdges, ACtdIsNotFrozenInLess) {
  Sensors sensors = withCtdStuckBelow();
  sensors.own_m = 22;
  sensors.run();
  sensors.own_m = 23.5;
  sensors.run(14);
  EXPECT_EQ(hookDepthWatchDeepest(&sensors.watch), 24.01) << "15 s";
  sensors.run();
  EXPECT_EQ(hookDepthWatchDeepest(&sensors.watch), 23.5) << "16 s";
}

/// Whether a CTD that agrees for `cycles`, then does as in `between`, then agrees for 9 cycles more
/// is known to work.
bool isKnownAfter(int cycles, void (*between)(Sensors&)) {
  Sensors sensors = sea(26);
  sensors.ctd_m = 24;
  sensors.run(cycles);
  between(sensors);
  sensors.own_m = 20;
  sensors.ctd_m = 24;
  sensors.run(9);
  return hookDepthWatchDeepest(&sensors.watch) > 22;
}

TEST(DepthWatchEdges, ACtdIsKnownOnceItHasAgreedForTenSecondsOnEnd) {
  EXPECT_FALSE(isKnownAfter(0, [](Sensors&) {})) << "9 s";
  EXPECT_TRUE(isKnownAfter(1, [](Sensors&) {}));
  EXPECT_FALSE(isKnownAfter(9, [](Sensors& s) {
    s.own_m = kMissing;
    s.run();
  }));
  EXPECT_FALSE(isKnownAfter(9, [](Sensors& s) {
    s.ctd_m = 26;
    s.run();
  })) << "it differed";
  EXPECT_FALSE(isKnownAfter(9, [](Sensors& s) {
    s.ctd_m = 60;
    s.run();
  })) << "it jumped";
  EXPECT_TRUE(isKnownAfter(9, [](Sensors& s) {
    s.ctd_m = kMissing;
    s.run();
  })) << "one that is not new agrees still";
}

TEST(DepthWatchEdges, FiveMetresApartAgreeMoreDisagreeAfterTenSeconds) {
  for (const double apart : {5.0, 5.0001}) {
    Sensors sensors = sea(20);
    sensors.own_still = sensors.ctd_still = true;
    sensors.own_m = 15;
    sensors.step_s = 10;
    sensors.run(3);  // what was before is forgotten
    sensors.step_s = 1;
    sensors.ctd_m = 15 + apart;
    EXPECT_EQ(sensors.run(9), HookGuard::None);
    EXPECT_EQ(sensors.run(), apart == 5 ? HookGuard::None : HookGuard::DepthsDisagree) << apart;
  }
}

TEST(DepthWatchEdges, ACtdThatFallsSilentDoesNotHaveTheLastWord) {
  Sensors sensors = sea(20);
  sensors.ctd_m = 24;
  sensors.run(30);
  sensors.ctd_m = 26;
  EXPECT_EQ(sensors.run(9), HookGuard::None);
  sensors.ctd_m = kMissing;
  EXPECT_EQ(sensors.run(20), HookGuard::None);
  sensors.ctd_m = 26;
  EXPECT_EQ(sensors.run(), HookGuard::DepthsDisagree) << "it differed all the time";
}

TEST(DepthWatchEdges, TheDepthIsConfirmedByANewCtdReadingThatAgrees) {
  Sensors sensors;
  sensors.run();
  EXPECT_FALSE(hookDepthWatchIsSeenByAnother(&sensors.watch));
  sensors.ctd_m = 20;
  sensors.run();
  EXPECT_TRUE(hookDepthWatchIsSeenByAnother(&sensors.watch));
  sensors.ctd_m = kMissing;
  sensors.run();
  EXPECT_FALSE(hookDepthWatchIsSeenByAnother(&sensors.watch)) << "there is none";
  sensors.ctd_m = 20;
  sensors.ctd_still = true;
  sensors.run(2);
  EXPECT_FALSE(hookDepthWatchIsSeenByAnother(&sensors.watch)) << "it is stuck";
  sensors.ctd_m = 25.01;
  sensors.run();
  EXPECT_FALSE(hookDepthWatchIsSeenByAnother(&sensors.watch)) << "it differs";
  sensors.ctd_m = 24;
  sensors.run();
  EXPECT_TRUE(hookDepthWatchIsSeenByAnother(&sensors.watch));
}

TEST(DepthWatchEdges, WithoutADepthTheCtdIsNone) {
  Sensors sensors;
  sensors.own_m = kMissing;
  sensors.ctd_m = 20;
  sensors.run();
  hookDepthWatchBelieveCtd(&sensors.watch);
  EXPECT_EQ(sensors.run(), HookGuard::DepthUnknown);
  EXPECT_TRUE(std::isnan(hookDepthWatchDeepest(&sensors.watch)));
}

TEST(DepthWatchEdges, ADepthThatJumpedForTenSecondsIsNotBelievedWhenItIsBack) {
  for (const int seconds : {9, 10}) {
    Sensors sensors = sea();
    sensors.own_m = 50;
    EXPECT_EQ(sensors.run(seconds), HookGuard::DepthJumps);
    sensors.own_m = 20;
    EXPECT_EQ(sensors.run(), seconds < 10 ? HookGuard::None : HookGuard::DepthJumps) << seconds;
  }
}

/// Not believed any more, near the surface.
Sensors frozenAt(double own_m) {
  Sensors sensors;
  sensors.own_m = own_m;
  sensors.pump_cc = kOut;
  sensors.run(200);
  sensors.own_still = true;
  sensors.own_m += 1.0 / 512;
  sensors.run(17);
  EXPECT_EQ(hookDepthWatchDoubt(&sensors.watch), HookGuard::DepthFrozen);
  EXPECT_TRUE(std::isnan(hookDepthWatchDepth(&sensors.watch)));
  sensors.own_still = false;
  sensors.own_m = own_m;
  return sensors;
}

TEST(DepthWatchEdges, WhatThawedIsBelievedAfterTwoMinutesOfClimbingAtMostThreeMetresDeep) {
  EXPECT_EQ(frozenAt(2.5).untilNoDoubt(), 120);
  EXPECT_EQ(frozenAt(3).untilNoDoubt(), 120);
  EXPECT_EQ(frozenAt(3.01).untilNoDoubt(), 1000);
}

TEST(DepthWatchEdges, ClimbingIsAnyPumpThatIsOut) {
  Sensors sensors = frozenAt(2.5);
  sensors.run(60);
  sensors.pump_cc = 0;
  sensors.run(100);
  sensors.pump_cc = kMissing;
  sensors.run(100);
  sensors.pump_cc = 0.5;
  EXPECT_EQ(sensors.untilNoDoubt(), 60);
}

TEST(DepthWatchEdges, ASmallChangeWhileThePumpTrimsDoesNotEndAFreeze) {
  Sensors sensors = frozenAt(2.5);
  sensors.own_still = true;
  sensors.own_m += 1.0 / 512;
  sensors.pump_cc = kTrims;
  sensors.run(30);
  sensors.own_still = false;
  sensors.own_m = 2.5;
  EXPECT_EQ(sensors.untilNoDoubt(), 120) << "of climbing since it moves";
}

TEST(DepthWatchEdges, AFrozenDepthIsBelievedAfterAMinuteOfAgreementWithTheCtd) {
  Sensors sensors = frozenAt(40);
  EXPECT_EQ(Sensors(sensors).untilNoDoubt(), 1000);
  sensors.run(200);
  sensors.ctd_m = 40;
  EXPECT_EQ(sensors.untilNoDoubt(), 60);
}

TEST(DepthWatchEdges, AMinuteWithoutDoubtIsNeededThoughTheCtdAgreesForLonger) {
  Sensors sensors = frozenAt(40);
  sensors.own_still = true;
  sensors.own_m += 1.0 / 512;
  sensors.ctd_m = 40;
  sensors.run(100);
  sensors.own_still = false;
  sensors.own_m = 40;
  EXPECT_EQ(sensors.untilNoDoubt(), 60);
}

/// Of a depth that would be believed in a second: how long it takes when `between` comes first.
int leftAfter(void (*between)(Sensors&), double own_m = 2.5) {
  Sensors sensors = frozenAt(own_m);
  sensors.run(119);
  between(sensors);
  return sensors.untilNoDoubt();
}

TEST(DepthWatchEdges, AMinuteWithoutAnythingWrongMustPass) {
  EXPECT_EQ(leftAfter([](Sensors&) {}), 1);
  EXPECT_EQ(leftAfter([](Sensors& s) {
              s.own_m = kMissing;
              s.run();
              s.own_m = 2.5;
            }),
            60)
      << "it was not there";
  EXPECT_EQ(leftAfter([](Sensors& s) {
              s.own_m = 50;
              s.run();
              s.own_m = 2.5;
            }),
            60)
      << "it jumped";
}

TEST(DepthWatchEdges, NoChangeForSixteenSecondsIsWrongBelowAMetre) {
  for (const double own_m : {1.0, 1.001}) {
    for (const int same : {15, 16}) {
      Sensors sensors = frozenAt(2.5);
      sensors.run(100);
      sensors.own_m = own_m;
      sensors.own_still = true;
      sensors.pump_cc = kTrims;  // frozen after a minute only
      EXPECT_EQ(sensors.run(same + 1), HookGuard::DepthFrozen);
      sensors.own_still = false;
      sensors.own_m = 1.01;
      const bool wrong = own_m > 1 && same == 16;
      EXPECT_EQ(sensors.untilNoDoubt(), wrong ? 60 : 120 - 101 - same) << own_m << " " << same;
    }
  }
}

TEST(DepthWatchEdges, DepthsThatDifferAreWrong) {
  EXPECT_EQ(leftAfter([](Sensors& s) {
              s.ctd_m = 8.5;
              s.run();
              s.ctd_m = 7;
            }),
            60);
}

TEST(DepthWatchEdges, AfterAJumpTheSurfaceIsNotEnoughButTheCtdIs) {
  Sensors sensors;
  sensors.own_m = 2;
  sensors.pump_cc = kOut;
  sensors.run(100);
  sensors.own_m = 30;
  sensors.run(10);
  sensors.own_m = 2;
  EXPECT_EQ(Sensors(sensors).untilNoDoubt(), 1000);
  sensors.own_still = true;
  sensors.own_m = 2.01;
  sensors.run(30);  // frozen now, too
  sensors.own_still = false;
  sensors.own_m = 2;
  EXPECT_EQ(Sensors(sensors).untilNoDoubt(), 1000) << "the jump is not forgotten";
  sensors.ctd_m = 2;
  EXPECT_EQ(sensors.untilNoDoubt(), 60);
}

TEST(DepthWatchEdges, AfterDepthsDisagreedTheCtdAloneIsNotEnough) {
  Sensors sensors = sea(20);
  sensors.ctd_m = 24;
  sensors.run(30);
  sensors.ctd_m = 26;
  EXPECT_EQ(sensors.run(10), HookGuard::DepthsDisagree);
  sensors.ctd_m = 22;
  EXPECT_EQ(sensors.untilNoDoubt(), 1000);
}

TEST(DepthWatchEdges, ADepthIsAliveWhileItIsKnownAndChanges) {
  Sensors sensors = sea();
  EXPECT_EQ(sensors.watch.alive_s, 100);
  sensors.own_m = kMissing;
  sensors.run();
  EXPECT_EQ(sensors.watch.alive_s, 0);
  sensors.own_m = 20;
  sensors.run(5);
  EXPECT_EQ(sensors.watch.alive_s, 5);
  sensors.own_still = true;
  sensors.own_m = 20.01;
  sensors.run(16);
  EXPECT_EQ(sensors.watch.alive_s, 21);
  sensors.run();
  EXPECT_EQ(sensors.watch.alive_s, 0);
  sensors.ctd_m = 20;
  sensors.run();
  EXPECT_EQ(sensors.watch.alive_s, 1) << "the CTD agrees";
}

TEST(DepthWatchEdges, TheCtdsDepthIsThereWhereItIsNewAndFollows) {
  Sensors sensors;
  sensors.ctd_still = true;
  sensors.ctd_m = 20;
  sensors.run();
  EXPECT_EQ(hookDepthWatchCtdDepth(&sensors.watch), 20);
  sensors.ctd_m = kMissing;
  sensors.run();
  EXPECT_TRUE(std::isnan(hookDepthWatchCtdDepth(&sensors.watch)));
  sensors.ctd_m = 50;
  sensors.run();
  EXPECT_TRUE(std::isnan(hookDepthWatchCtdDepth(&sensors.watch))) << "it jumped";
  sensors.run();
  EXPECT_EQ(hookDepthWatchCtdDepth(&sensors.watch), 50);
}

}  // namespace
}  // namespace glider::hooks
