// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Where exactly each limit of HookUnseenSink lies, in cycles of a second and in metres.

#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/unseen_sink.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/begun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glider::hooks {
namespace {

constexpr double kUnread = std::numeric_limits<double>::quiet_NaN();
constexpr VerticalCommand kSteepDive{-0.7854, -230}, kSteepLift{0.7854, 230}, kNoStroke{0, 0},
    kNoPump{0, kUnread};
constexpr double kSteepSinkMps = 1.1 * 0.4, kFlatSinkMps = kSteepSinkMps * 0.3 / 0.7854,
                 kStillMps = 0.1;

/// No two readings are the same to the last bit.
void run(HookUnseenSink& sink, int cycles, double depth_m, const VerticalCommand& command) {
  for (int i = 0; i < cycles; ++i) {
    hookUnseenSinkObserve(&sink, depth_m + i % 2 * 1e-9, 1, &command);
  }
}

/// It has been at this depth for as long as it takes for all that follows to count.
HookUnseenSink settledAt(double depth_m, const VerticalCommand& command = kNoStroke) {
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
  run(sink, 13, depth_m, command);
  hookUnseenSinkConfirm(&sink, depth_m);
  return sink;
}

/// m/s that it is assumed to sink at under `command`.
double rateUnder(const VerticalCommand& command) {
  HookUnseenSink sink = settledAt(20);
  run(sink, 1, 20, command);
  return sink.deepest_m - 20;
}

TEST(UnseenSinkEdges, WhatSinksIsSixtyCcInOrTheNoseATenthDown) {
  EXPECT_NEAR(rateUnder({0, -60}), kFlatSinkMps, 1e-9);
  EXPECT_NEAR(rateUnder({0, -59.9}), kStillMps, 1e-9);
  EXPECT_NEAR(rateUnder({-0.1, 0}), kFlatSinkMps, 1e-9);
  EXPECT_NEAR(rateUnder({-0.0999, 0}), kStillMps, 1e-9);
  EXPECT_NEAR(rateUnder({0.1, 116.5}), kFlatSinkMps, 1e-9) << "it has not turned yet";
  EXPECT_NEAR(rateUnder({0.1, 116.4}), kStillMps, 1e-9);
  EXPECT_NEAR(rateUnder({0.0999, 116.5}), kStillMps, 1e-9);
}

TEST(UnseenSinkEdges, TheRateIsThatOfThePitchButNeverBelowThatOfSeventeenDegrees) {
  EXPECT_NEAR(rateUnder({-0.29, -230}), kFlatSinkMps, 1e-9);
  EXPECT_NEAR(rateUnder({-0.31, -230}), kSteepSinkMps * 0.31 / 0.7854, 1e-9);
  EXPECT_NEAR(rateUnder({0.5, -230}), kSteepSinkMps * 0.5 / 0.7854, 1e-9);
  EXPECT_NEAR(rateUnder({kUnread, -230}), kFlatSinkMps, 1e-9) << "an unknown one as if level";
}

TEST(UnseenSinkEdges, ItIsADiveFromATenthDown) {
  for (const double pitch : {-0.1, -0.0999}) {
    HookUnseenSink sink = settledAt(20);
    run(sink, 1, 20, {pitch, -230});
    EXPECT_NEAR(sink.in_dive_m, pitch == -0.1 ? kFlatSinkMps : 0, 1e-9);
    EXPECT_NEAR(sink.steeply_m, pitch == -0.1 ? kSteepSinkMps : 0, 1e-9);
  }
}

TEST(UnseenSinkEdges, TheFirstTwelveSecondsDoNotCount) {
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
  run(sink, 12, 20, kSteepDive);
  EXPECT_EQ(sink.deepest_m, 20);
  EXPECT_EQ(sink.in_dive_m, 0);
  run(sink, 1, 20, kSteepDive);
  EXPECT_NEAR(sink.deepest_m, 20 + kSteepSinkMps, 1e-9);
  EXPECT_NEAR(sink.in_dive_m, kSteepSinkMps, 1e-9);
}

TEST(UnseenSinkEdges, ItRisesAfterTwentySecondsAndSinksTwelveSecondsAfterThat) {
  HookUnseenSink sink = settledAt(20, kSteepDive);
  run(sink, 20, 20, kSteepLift);
  const double turned = 20 + 20 * kSteepSinkMps;
  EXPECT_NEAR(sink.deepest_m, turned, 1e-9);
  EXPECT_GT(sink.in_dive_m, 0);
  run(sink, 1, 20, kSteepLift);
  EXPECT_NEAR(sink.deepest_m, turned - 0.1, 1e-9);
  EXPECT_EQ(sink.in_dive_m, 0);
  EXPECT_EQ(sink.steeply_m, 0);
  run(sink, 12, 20, kSteepDive);
  EXPECT_NEAR(sink.deepest_m, turned - 0.1, 1e-9);
  run(sink, 1, 20, kSteepDive);
  EXPECT_NEAR(sink.deepest_m, turned - 0.1 + kSteepSinkMps, 1e-9);
  run(sink, 20, 20, kSteepLift);
  EXPECT_NEAR(sink.deepest_m, turned - 0.1 + 21 * kSteepSinkMps, 1e-9) << "another twenty seconds";
}

/// A climb of 4 to 16 s drives the pump out, and the dive after it brings it back first.
TEST(UnseenSinkEdges, AShortClimbPutsOffTheNextDiveByAsMuchLessFourSeconds) {
  for (const auto& [climbs, waits] : {std::pair{4, 0}, {5, 1}, {10, 6}, {16, 12}, {20, 12}}) {
    HookUnseenSink sink = settledAt(20, kSteepDive);
    run(sink, climbs, 20, kSteepLift);
    const double turned = sink.deepest_m;
    run(sink, waits, 20, kSteepDive);
    EXPECT_NEAR(sink.deepest_m, turned, 1e-9) << climbs;
    run(sink, 1, 20, kSteepDive);
    EXPECT_NEAR(sink.deepest_m, turned + kSteepSinkMps, 1e-9) << climbs;
  }
}

TEST(UnseenSinkEdges, AnotherBehavioursCycleEndsTheDiveAndTheClimb) {
  HookUnseenSink sink = settledAt(20, kSteepDive);
  run(sink, 1, 20, kSteepDive);
  run(sink, 1, 20, kNoPump);
  EXPECT_EQ(sink.in_dive_m, 0);
  EXPECT_EQ(sink.steeply_m, 0);
  run(sink, 20, 20, kSteepLift);
  run(sink, 1, 20, kNoPump);
  const double before = sink.deepest_m;
  run(sink, 20, 20, kSteepLift);
  EXPECT_NEAR(sink.deepest_m, before + 20 * kSteepSinkMps, 1e-9) << "it turns again";
}

/// Under `command`: from `from` to `to` in steps that a vehicle makes, a second each.
void walk(HookUnseenSink& sink, double from, double to, const VerticalCommand& command) {
  const double step = from < to ? 0.25 : -0.25;
  for (double depth = from; depth != to;) {
    depth += step;
    hookUnseenSinkObserve(&sink, depth, 1, &command);
  }
}

TEST(UnseenSinkEdges, ItMovesFromTwoAndAHalfMetresOn) {
  for (const double way : {1.0, -1.0}) {
    HookUnseenSink sink = settledAt(20);
    walk(sink, 20, 20 + 2.25 * way, kNoStroke);
    hookUnseenSinkObserve(&sink, 20 + 2.499 * way, 1, &kNoStroke);
    EXPECT_FALSE(sink.has_moved) << way;
    hookUnseenSinkObserve(&sink, 20 + 2.5 * way, 1, &kNoStroke);
    EXPECT_TRUE(sink.has_moved) << way;
    EXPECT_EQ(sink.shown_m, 20 + 2.5 * way);
    EXPECT_EQ(sink.deepest_m, 20 + 2.5 * way);
  }
}

TEST(UnseenSinkEdges, WhatMovesBeginsANewDive) {
  HookUnseenSink sink = settledAt(20, kSteepDive);
  walk(sink, 20, 22.5, kSteepDive);
  EXPECT_TRUE(sink.has_moved);
  EXPECT_EQ(sink.in_dive_m, 0);
  EXPECT_EQ(sink.steeply_m, 0);
}

TEST(UnseenSinkEdges, TheDistanceCountsFromItsTurningPoint) {
  for (const double way : {1.0, -1.0}) {
    HookUnseenSink sink = settledAt(20);
    walk(sink, 20, 20 + 2 * way, kNoStroke);
    walk(sink, 20 + 2 * way, 20 - 0.25 * way, kNoStroke);
    EXPECT_FALSE(sink.has_moved) << way;
    hookUnseenSinkObserve(&sink, 20 - 0.5 * way, 1, &kNoStroke);
    EXPECT_TRUE(sink.has_moved) << way << ": 2.5 m from where it turned";
  }
}

TEST(UnseenSinkEdges, UpwardsCountsFromTwelveSecondsOfClimbOn) {
  HookUnseenSink sink = settledAt(20, kSteepDive);
  run(sink, 1, 20, kSteepLift);
  walk(sink, 20, 17.5, kSteepLift);
  EXPECT_FALSE(sink.has_moved) << "11 s";
  hookUnseenSinkObserve(&sink, 17.5, 1, &kSteepLift);
  EXPECT_FALSE(sink.has_moved) << "a reading that the array keeps is not a new one";
  hookUnseenSinkObserve(&sink, 17.499, 1, &kSteepLift);
  EXPECT_TRUE(sink.has_moved) << "12 s";
}

TEST(UnseenSinkEdges, DownwardsDoesNotCountWhereItIsDrivenUp) {
  HookUnseenSink sink = settledAt(20);
  walk(sink, 20, 23, kSteepLift);
  EXPECT_FALSE(sink.has_moved);
  hookUnseenSinkObserve(&sink, 23.001, 1, &kNoStroke);
  EXPECT_TRUE(sink.has_moved);
}

TEST(UnseenSinkEdges, WhatRoseIsNotDrivenDownWhenAnotherBehaviourHasIt) {
  HookUnseenSink sink = settledAt(20, kSteepDive);
  run(sink, 21, 20, kSteepLift);
  walk(sink, 20, 17.5, kNoPump);
  EXPECT_TRUE(sink.has_moved);
  sink = settledAt(20, kSteepDive);
  run(sink, 20, 20, kSteepLift);
  walk(sink, 20, 17.5, kNoPump);
  EXPECT_FALSE(sink.has_moved) << "it may sink still";
  sink = settledAt(20, kSteepDive);
  run(sink, 20, 20, kNoPump);
  walk(sink, 20, 17.5, kNoPump);
  EXPECT_TRUE(sink.has_moved) << "it no longer does";
}

constexpr double kReachIn4S = kSteepSinkMps * 4 + 0.5;

TEST(UnseenSinkEdges, AStepThatNoVehicleMakesRestartsIt) {
  for (const bool too_far : {false, true}) {
    const double step = too_far ? std::nextafter(kReachIn4S, 9) : kReachIn4S;
    HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
    hookUnseenSinkObserve(&sink, 0, 4, &kNoPump);
    hookUnseenSinkObserve(&sink, step, 4, &kNoPump);
    hookUnseenSinkObserve(&sink, 3, 4, &kNoPump);
    EXPECT_EQ(sink.has_moved, !too_far);
  }
}

TEST(UnseenSinkEdges, AGapOfMoreThanTwentySecondsRestartsIt) {
  for (const double gap : {20.0, 21.0}) {
    HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
    hookUnseenSinkObserve(&sink, 20, 1, &kNoPump);
    run(sink, 19, kUnread, kNoPump);
    hookUnseenSinkObserve(&sink, 29, gap - 19,
                          &kNoPump);  // as far as it may: and that is not roughness
    EXPECT_EQ(sink.has_moved, gap == 20) << gap;
  }
}

TEST(UnseenSinkEdges, WhatIsRoughMustGoFarther) {
  for (const double off : {0.05, 0.5}) {
    HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);
    for (int i = 0; i < 40; ++i) {
      hookUnseenSinkObserve(&sink, 20 + (i % 2 == 0 ? off : -off), 4, &kNoPump);
    }
    hookUnseenSinkObserve(&sink, 21.5, 4, &kNoPump);
    hookUnseenSinkObserve(&sink, 23, 4, &kNoPump);
    EXPECT_EQ(sink.has_moved, off == 0.05) << off;
  }
}

TEST(UnseenSinkEdges, RoughnessCountsInRealTime) {
  HookUnseenSink sink = begun(hookUnseenSinkInit, &kHull);  // steadily down, with gaps that differ
  double depth = 20;
  for (const double gap : {4.0, 15.0, 4.0, 4.5, 16.0, 4.0, 15.0, 8.0}) {
    hookUnseenSinkObserve(&sink, depth += 0.17 * gap, gap, &kNoPump);
  }
  EXPECT_NEAR(hookUnseenSinkLateBy(&sink), 0, 4) << "by the rare readings alone";
  EXPECT_TRUE(sink.has_moved);
}

TEST(UnseenSinkEdges, AConfirmedDepthIsWhereItCountsFrom) {
  HookUnseenSink sink = settledAt(20, kSteepDive);
  hookUnseenSinkConfirm(&sink, 25);
  EXPECT_EQ(sink.shown_m, 25);
  EXPECT_EQ(sink.deepest_m, 25);
  EXPECT_EQ(sink.steeply_m, 0);
  EXPECT_NEAR(sink.in_dive_m, kSteepSinkMps, 1e-9);
  run(sink, 1, 20, kSteepDive);
  EXPECT_NEAR(sink.deepest_m, 25 + kSteepSinkMps, 1e-9);
}

}  // namespace
}  // namespace glider::hooks
