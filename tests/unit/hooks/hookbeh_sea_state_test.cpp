// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Healthy vehicles whose depth moves otherwise than by their own motion once in 4 s: pressure read
// every few cycles, cycles of unequal length, swell. No guard may intervene.

#include "hooks/hookbeh/cadence.h"
#include "hooks/hookbeh/depth_source.h"
#include "hooks/hookbeh/trend.h"
#include "hooks/hookbeh/unseen_sink.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/begun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace glider::hooks {
namespace {

constexpr double kNoDepth = std::numeric_limits<double>::quiet_NaN();
constexpr VerticalCommand kSeaDive{-0.4538, -230}, kLift{0.4538, 230}, kHover{0, 0};

TEST(Cadence, AReadingThatTheArrayKeepsIsNotNew) {
  HookCadence cadence = begun(hookCadenceInit);
  const double depths[] = {20, 20, 20, 20.5, kNoDepth, 20.5, 21};
  const bool news[] = {true, false, false, true, false, false, true};
  for (size_t i = 0; i < std::size(depths); ++i) {
    hookCadenceObserve(&cadence, depths[i], 4);
    EXPECT_EQ(cadence.is_new, news[i]) << i;
  }
  EXPECT_EQ(cadence.since_s, 12);
}

/// The usual gap after `count` readings every `gap_s`.
double usualAfter(int count, double gap_s) {
  HookCadence cadence = begun(hookCadenceInit);
  for (int i = 0; i < count; ++i) {
    hookCadenceObserve(&cadence, 20 + i * 0.1, gap_s);
  }
  return cadence.usual_s;
}

TEST(Cadence, IsLearnedFromTheFifthReadingOn) {
  EXPECT_EQ(usualAfter(4, 16), 4);
  EXPECT_EQ(usualAfter(5, 16), 16);
  EXPECT_EQ(usualAfter(5, 100), 32) << "more is a fault";
}

TEST(Cadence, FollowsASensorThatFailsSlowly) {
  HookCadence cadence = begun(hookCadenceInit);
  for (int i = 0; i < 200; ++i) {
    hookCadenceObserve(&cadence, 20 + i * 0.1, 4);
  }
  for (int i = 0; i < 3; ++i) {
    hookCadenceObserve(&cadence, 50 + i, 16);
  }
  EXPECT_LT(cadence.usual_s, 9);
}

TEST(Cadence, TheZeroOfTheSurfaceIsNoCadence) {
  HookCadence cadence = begun(hookCadenceInit);
  for (int i = 0; i < 20; ++i) {
    hookCadenceObserve(&cadence, i % 10 == 0 ? i * 0.01 : 0, 4);
  }
  EXPECT_EQ(cadence.usual_s, 4);
}

/// A climb that checks the depth of a hover, and the way back, with the pressure read every 12 s:
/// readings in calm water that are up to a metre off the line between their neighbours.
TEST(UnseenSink, ATurnIsNotRough) {
  const std::pair<VerticalCommand, std::vector<double>> legs[] = {
      {kHover, {48.4, 48.3, 48.4, 48.4, 48.3, 48.4, 48.3, 48.4}},
      {kLift, {48.1, 46.5, 44.1}},
      {kSeaDive, {42.3, 42.5, 43.5, 45.1}}};
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
  for (const auto& [command, depths] : legs) {
    for (const double depth : depths) {
      for (int i = 0; i < 3; ++i) {
        hookUnseenSinkObserve(&sink, depth, 4, &command);
      }
    }
  }
  EXPECT_EQ(sink.shown_m, 45.1) << "2.8 m down from where it turned";
}

TEST(DepthSource, APatienceIsTwiceTheUsualGap) {
  for (const double gap : {4.0, 10.0, 16.0}) {
    HookDepthSource source = begun(hookDepthSourceInit, &kHull);
    for (int i = 0; i < 20; ++i) {
      hookDepthSourceObserve(&source, 20 + i * 0.1, gap);
    }
    EXPECT_EQ(hookDepthSourcePatience(&source), gap == 4 ? 16 : 2 * gap + 4);
  }
}

TEST(DepthSource, AReadingAfterARareOneIsNoJump) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  for (int i = 0; i < 40; ++i) {  // 0.38 m/s, read every fourth cycle
    hookDepthSourceObserve(&source, 20 + 0.38 * 16 * (i / 4), 4);
    ASSERT_EQ(source.reading, HookDepthReading::Good) << i;
  }
  hookDepthSourceObserve(&source, 20 + 0.38 * 16 * 10 + 12, 4);
  EXPECT_EQ(source.reading, HookDepthReading::Jumped);
}

/// A dive at `mps` in swell, read at every `every`-th cycle. The longest that its depth did not
/// show it, m.
struct SeaState {
  double mps = 0.17;
  double swell_m = 0, period_s = 10;
  int every = 1;
  double long_share = 0;  ///< of the cycles, which take 15 s
};
double mostUnseen(const SeaState& sea) {
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
  double time = 0, depth = 5, most = 0, draw = 0.7;
  for (int i = 0; i < 400; ++i) {
    draw = 3.99 * draw * (1 - draw);
    const double step = draw < sea.long_share ? 15 : sea.long_share > 0 ? 4.4 : 4;
    time += step;
    const double true_m = 5 + sea.mps * time;
    if (i % sea.every == 0) {
      depth = true_m + sea.swell_m * std::sin(2 * std::numbers::pi * time / sea.period_s);
    }
    hookUnseenSinkObserve(&sink, depth, step, &kSeaDive);
    if (time > 200) {
      most = std::max(most, sink.deepest_m - sink.shown_m - hookUnseenSinkLateBy(&sink));
    }
  }
  return most;
}

constexpr double kAllowed = 7;  // m, and lateBy()

TEST(UnseenSink, ADiveShowsItselfThoughItsPressureIsReadRarely) {
  for (const int every : {1, 2, 3, 4}) {
    for (const double mps : {0.12, 0.17, 0.19}) {
      EXPECT_LT(mostUnseen({.mps = mps, .every = every}), kAllowed) << every << " " << mps;
    }
  }
}

TEST(UnseenSink, ADiveShowsItselfInSwellOfAMetre) {
  for (const double period : {6.0, 7.0, 8.5, 10.0, 12.0, 14.0}) {
    for (const double swell : {0.3, 0.5, 0.8, 1.0}) {
      EXPECT_LT(mostUnseen({.swell_m = swell, .period_s = period}), kAllowed)
          << swell << " m, " << period << " s";
    }
  }
}

TEST(UnseenSink, ADiveShowsItselfInUnequalCycles) {
  for (const double share : {0.03, 0.1}) {
    EXPECT_LT(mostUnseen({.long_share = share}), kAllowed) << share;
    EXPECT_LT(mostUnseen({.swell_m = 0.5, .long_share = share}), kAllowed) << share;
  }
}

/// How often an hour of a stuck depth that flickers by up to `by` shows the vehicle.
int shownInAnHour(double by, const VerticalCommand& command) {
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
  double draw = 0.3;
  int shown = 0;
  for (int i = 0; i < 900; ++i) {
    draw = 3.99 * draw * (1 - draw);
    const double before = sink.deepest_m;
    hookUnseenSinkObserve(&sink, 20 + by * (2 * draw - 1), 4, &command);
    shown += sink.deepest_m < before - 0.5;
  }
  return shown;
}

TEST(UnseenSink, AStuckDepthThatFlickersDoesNotShowADive) {
  for (const double by : {0.02, 0.3, 0.6, 0.8, 1.2}) {
    EXPECT_LE(shownInAnHour(by, kSeaDive), 1) << by;
  }
  EXPECT_LE(shownInAnHour(1.6, kSeaDive), 4) << "as rough as swell of a metre and a half";
}

TEST(UnseenSink, AnswersCountOnlyWhatMovesAsThePitchDrivesIt) {
  for (const VerticalCommand& command : {kSeaDive, kHover, kLift}) {
    HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
    double depth = 20;
    for (int i = 0; i < 20; ++i) {
      hookUnseenSinkObserve(&sink, depth += i % 2 * 0.01, 4, &kHover);
    }
    const double before = sink.unanswered_m;
    EXPECT_GT(before, 5) << "0.1 m/s adrift";
    hookUnseenSinkConfirm(&sink, depth);
    EXPECT_EQ(sink.unanswered_m, before) << "another sensor is not an answer";
    for (int i = 0; i < 12; ++i) {
      hookUnseenSinkObserve(&sink, depth += command.pitch_rad > 0 ? -0.5 : 0.5, 4, &command);
    }
    EXPECT_EQ(sink.unanswered_m < before, command.pitch_rad != 0);
  }
}

TEST(UnseenSink, WhatItDidBeforeItWasDrivenUpIsNotAnAnswer) {
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
  double depth = 20;
  for (int i = 0; i < 20; ++i) {
    hookUnseenSinkObserve(&sink, depth -= 0.1, 4, &kHover);
  }
  for (int i = 0; i < 10; ++i) {
    hookUnseenSinkObserve(&sink, depth + i % 2 * 0.01, 4, &kLift);
  }
  EXPECT_GT(sink.unanswered_m, 0);
}

}  // namespace
}  // namespace glider::hooks
