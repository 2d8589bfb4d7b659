// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Heartbeats that hookprog gives in the place of an SBC that sleeps: for how long they count.

#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::hooks {
namespace {

/// In control; from then on the test gives the heartbeats.
class NapOfHookbeh {
 public:
  explicit NapOfHookbeh(double nap_secs) : bench(args(nap_secs)) {
    bench.cycle();
    bench.give(HookbehBench::take());
    bench.give(HookbehBench::vertical(HookVertical::Surface));
    bench.alive = false;
    beat_ = bench.beats;
  }

  static HookbehArgs args(double nap_secs) {
    HookbehArgs args;
    args.nap_secs = nap_secs;
    return args;
  }

  HookState own() { return with(++beat_); }
  /// In one nap the numbers are all even, or all odd.
  HookState asleep() { return with(-(beat_ += 2)); }
  HookState inAnotherNap() { return with(-(beat_ += 1)); }
  HookState with(double heartbeat) {
    bench.inputs.heartbeat = heartbeat;
    return bench.cycle().state;
  }
  /// The cycles with heartbeats of an SBC that sleeps, until it loses control; at most 1000.
  int cyclesAsleep() {
    int cycles = 0;
    while (cycles < 1000 && asleep() == HookState::Active) {
      ++cycles;
    }
    return cycles;
  }

  HookbehBench bench;
  double beat_ = 0;
};

constexpr int kSilence = 6;  // cycles: 24 s

TEST(HookbehNaps, WithoutNapSecsOnlyTheSbcItselfKeepsControl) {
  NapOfHookbeh nap(0);
  EXPECT_EQ(nap.own(), HookState::Active);
  EXPECT_EQ(nap.cyclesAsleep(), kSilence - 1) << "as if nothing beat";
}

TEST(HookbehNaps, InItsPlaceTheyCountForNapSecsToTheCycle) {
  for (const double secs : {40.0, 40.1, 43.9, 44.0}) {
    NapOfHookbeh nap(secs);
    EXPECT_EQ(nap.own(), HookState::Active);
    // The last that counts is in the last cycle before `nap_secs` have passed.
    const int counted = static_cast<int>(std::ceil(secs / 4)) - 1;
    EXPECT_EQ(nap.cyclesAsleep(), counted + kSilence - 1) << secs;
  }
}

TEST(HookbehNaps, TheSbcIsSilentAtTheLatestAfterNapSecsAndSilenceSecs) {
  constexpr double kNapSecs = 300, kSilenceSecs = 24, kCycle = 4;
  NapOfHookbeh nap(kNapSecs);
  const double heard_s = nap.bench.inputs.time_s;
  nap.cyclesAsleep();
  EXPECT_LE(nap.bench.inputs.time_s - heard_s, kNapSecs + kSilenceSecs + kCycle);
  EXPECT_GE(nap.bench.inputs.time_s - heard_s, kNapSecs);
}

TEST(HookbehNaps, OneOfItsOwnBeginsTheTimeAnew) {
  NapOfHookbeh nap(40);
  for (int i = 0; i < 20; ++i) {
    for (int asleep = 0; asleep < 9; ++asleep) {
      ASSERT_EQ(nap.asleep(), HookState::Active);
    }
    ASSERT_EQ(nap.own(), HookState::Active);
  }
}

TEST(HookbehNaps, ARepeatedOneCountsNeitherAsOwnNorInItsPlace) {
  NapOfHookbeh nap(3600);
  EXPECT_EQ(nap.own(), HookState::Active);
  EXPECT_EQ(nap.asleep(), HookState::Active);
  const double repeated = -nap.beat_;
  for (int i = 1; i < kSilence; ++i) {
    ASSERT_EQ(nap.with(i % 2 == 0 ? repeated : -repeated), HookState::Active) << i;
  }
  EXPECT_EQ(nap.with(repeated + 1), HookState::Silent) << "nor an earlier one";
}

TEST(HookbehNaps, OneThatDoesNotCountStillMakesEarlierOnesOld) {
  NapOfHookbeh nap(0);
  EXPECT_EQ(nap.own(), HookState::Active);
  const double own = nap.beat_ + 1;
  EXPECT_EQ(nap.asleep(), HookState::Active);
  for (int i = 2; i < kSilence; ++i) {
    ASSERT_EQ(nap.with(own), HookState::Active) << i;
  }
  EXPECT_EQ(nap.with(own), HookState::Silent);
}

/// The nap of an SBC that was lost is not that of the next one.
TEST(HookbehNaps, ATakeBeginsTheTimeAnew) {
  NapOfHookbeh nap(40);
  nap.cyclesAsleep();
  nap.bench.write(HookbehBench::take(20, 2));
  ASSERT_EQ(nap.asleep(), HookState::Active);
  EXPECT_EQ(nap.cyclesAsleep(), 9 + kSilence - 1);
}

/// The line may lose the one heartbeat between two naps.
TEST(HookbehNaps, ANapWithOtherNumbersBeginsTheTimeAnewFromTheLastHeartbeat) {
  NapOfHookbeh nap(40);
  EXPECT_EQ(nap.own(), HookState::Active);
  for (int i = 0; i < 8; ++i) {
    ASSERT_EQ(nap.asleep(), HookState::Active) << i;
  }
  EXPECT_EQ(nap.inAnotherNap(), HookState::Active);
  EXPECT_EQ(nap.cyclesAsleep(), 8 + kSilence - 1) << "one cycle is over already";
}

TEST(HookbehNaps, AfterCyclesWithoutAHeartbeatTheNextNapHasSoMuchLess) {
  NapOfHookbeh nap(40);
  EXPECT_EQ(nap.own(), HookState::Active);
  EXPECT_EQ(nap.asleep(), HookState::Active);
  const double last = -nap.beat_;
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(nap.with(last), HookState::Active) << i;
  }
  EXPECT_EQ(nap.inAnotherNap(), HookState::Active);
  EXPECT_EQ(nap.cyclesAsleep(), 5 + kSilence - 1);
}

TEST(HookbehNaps, NapSecsIsReportedAsFarAsTheHullAllows) {
  for (const auto& [given, reported] :
       {std::pair(0.0, 0.0), {120.5, 120.5}, {3660, 3660}, {3661, 3660}, {1e9, 3660}, {-1, -1}}) {
    EXPECT_EQ(HookbehBench(NapOfHookbeh::args(given)).cycle().nap_secs, reported);
  }
  EXPECT_TRUE(std::isnan(HookbehBench(NapOfHookbeh::args(kNan)).cycle().nap_secs));
  NapOfHookbeh nap(kNan);
  EXPECT_EQ(nap.own(), HookState::Active);
  EXPECT_EQ(nap.cyclesAsleep(), kSilence - 1) << "no naps";
}

}  // namespace
}  // namespace glider::hooks
