// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Where exactly each limit of UnseenSink lies, in cycles of a second and in metres.

#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/unseen_sink.h"
#include "tests/slocum.h"

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
void run(UnseenSink& sink, int cycles, double depth_m, const VerticalCommand& command) {
  for (int i = 0; i < cycles; ++i) {
    sink.observe(depth_m + i % 2 * 1e-9, 1, command);
  }
}

/// It has been at this depth for as long as it takes for all that follows to count.
UnseenSink settledAt(double depth_m, const VerticalCommand& command = kNoStroke) {
  UnseenSink sink{kHull};
  run(sink, 13, depth_m, command);
  sink.confirm(depth_m);
  return sink;
}

/// m/s that it is assumed to sink at under `command`.
double rateUnder(const VerticalCommand& command) {
  UnseenSink sink = settledAt(20);
  run(sink, 1, 20, command);
  return sink.deepest() - 20;
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
    UnseenSink sink = settledAt(20);
    run(sink, 1, 20, {pitch, -230});
    EXPECT_NEAR(sink.sunkInDive(), pitch == -0.1 ? kFlatSinkMps : 0, 1e-9);
    EXPECT_NEAR(sink.sunkSteeply(), pitch == -0.1 ? kSteepSinkMps : 0, 1e-9);
  }
}

TEST(UnseenSinkEdges, TheFirstTwelveSecondsDoNotCount) {
  UnseenSink sink{kHull};
  run(sink, 12, 20, kSteepDive);
  EXPECT_EQ(sink.deepest(), 20);
  EXPECT_EQ(sink.sunkInDive(), 0);
  run(sink, 1, 20, kSteepDive);
  EXPECT_NEAR(sink.deepest(), 20 + kSteepSinkMps, 1e-9);
  EXPECT_NEAR(sink.sunkInDive(), kSteepSinkMps, 1e-9);
}

TEST(UnseenSinkEdges, ItRisesAfterTwentySecondsAndSinksTwelveSecondsAfterThat) {
  UnseenSink sink = settledAt(20, kSteepDive);
  run(sink, 20, 20, kSteepLift);
  const double turned = 20 + 20 * kSteepSinkMps;
  EXPECT_NEAR(sink.deepest(), turned, 1e-9);
  EXPECT_GT(sink.sunkInDive(), 0);
  run(sink, 1, 20, kSteepLift);
  EXPECT_NEAR(sink.deepest(), turned - 0.1, 1e-9);
  EXPECT_EQ(sink.sunkInDive(), 0);
  EXPECT_EQ(sink.sunkSteeply(), 0);
  run(sink, 12, 20, kSteepDive);
  EXPECT_NEAR(sink.deepest(), turned - 0.1, 1e-9);
  run(sink, 1, 20, kSteepDive);
  EXPECT_NEAR(sink.deepest(), turned - 0.1 + kSteepSinkMps, 1e-9);
  run(sink, 20, 20, kSteepLift);
  EXPECT_NEAR(sink.deepest(), turned - 0.1 + 21 * kSteepSinkMps, 1e-9) << "another twenty seconds";
}

/// A climb of 4 to 16 s drives the pump out, and the dive after it brings it back first.
TEST(UnseenSinkEdges, AShortClimbPutsOffTheNextDiveByAsMuchLessFourSeconds) {
  for (const auto& [climbs, waits] : {std::pair{4, 0}, {5, 1}, {10, 6}, {16, 12}, {20, 12}}) {
    UnseenSink sink = settledAt(20, kSteepDive);
    run(sink, climbs, 20, kSteepLift);
    const double turned = sink.deepest();
    run(sink, waits, 20, kSteepDive);
    EXPECT_NEAR(sink.deepest(), turned, 1e-9) << climbs;
    run(sink, 1, 20, kSteepDive);
    EXPECT_NEAR(sink.deepest(), turned + kSteepSinkMps, 1e-9) << climbs;
  }
}

TEST(UnseenSinkEdges, AnotherBehavioursCycleEndsTheDiveAndTheClimb) {
  UnseenSink sink = settledAt(20, kSteepDive);
  run(sink, 1, 20, kSteepDive);
  run(sink, 1, 20, kNoPump);
  EXPECT_EQ(sink.sunkInDive(), 0);
  EXPECT_EQ(sink.sunkSteeply(), 0);
  run(sink, 20, 20, kSteepLift);
  run(sink, 1, 20, kNoPump);
  const double before = sink.deepest();
  run(sink, 20, 20, kSteepLift);
  EXPECT_NEAR(sink.deepest(), before + 20 * kSteepSinkMps, 1e-9) << "it turns again";
}

/// Under `command`: from `from` to `to` in steps that a vehicle makes, a second each.
void walk(UnseenSink& sink, double from, double to, const VerticalCommand& command) {
  const double step = from < to ? 0.25 : -0.25;
  for (double depth = from; depth != to;) {
    depth += step;
    sink.observe(depth, 1, command);
  }
}

TEST(UnseenSinkEdges, ItMovesFromTwoAndAHalfMetresOn) {
  for (const double way : {1.0, -1.0}) {
    UnseenSink sink = settledAt(20);
    walk(sink, 20, 20 + 2.25 * way, kNoStroke);
    sink.observe(20 + 2.499 * way, 1, kNoStroke);
    EXPECT_FALSE(sink.hasMoved()) << way;
    sink.observe(20 + 2.5 * way, 1, kNoStroke);
    EXPECT_TRUE(sink.hasMoved()) << way;
    EXPECT_EQ(sink.shown(), 20 + 2.5 * way);
    EXPECT_EQ(sink.deepest(), 20 + 2.5 * way);
  }
}

TEST(UnseenSinkEdges, WhatMovesBeginsANewDive) {
  UnseenSink sink = settledAt(20, kSteepDive);
  walk(sink, 20, 22.5, kSteepDive);
  EXPECT_TRUE(sink.hasMoved());
  EXPECT_EQ(sink.sunkInDive(), 0);
  EXPECT_EQ(sink.sunkSteeply(), 0);
}

TEST(UnseenSinkEdges, TheDistanceCountsFromItsTurningPoint) {
  for (const double way : {1.0, -1.0}) {
    UnseenSink sink = settledAt(20);
    walk(sink, 20, 20 + 2 * way, kNoStroke);
    walk(sink, 20 + 2 * way, 20 - 0.25 * way, kNoStroke);
    EXPECT_FALSE(sink.hasMoved()) << way;
    sink.observe(20 - 0.5 * way, 1, kNoStroke);
    EXPECT_TRUE(sink.hasMoved()) << way << ": 2.5 m from where it turned";
  }
}

TEST(UnseenSinkEdges, UpwardsCountsFromTwelveSecondsOfClimbOn) {
  UnseenSink sink = settledAt(20, kSteepDive);
  run(sink, 1, 20, kSteepLift);
  walk(sink, 20, 17.5, kSteepLift);
  EXPECT_FALSE(sink.hasMoved()) << "11 s";
  sink.observe(17.5, 1, kSteepLift);
  EXPECT_FALSE(sink.hasMoved()) << "a reading that the array keeps is not a new one";
  sink.observe(17.499, 1, kSteepLift);
  EXPECT_TRUE(sink.hasMoved()) << "12 s";
}

TEST(UnseenSinkEdges, DownwardsDoesNotCountWhereItIsDrivenUp) {
  UnseenSink sink = settledAt(20);
  walk(sink, 20, 23, kSteepLift);
  EXPECT_FALSE(sink.hasMoved());
  sink.observe(23.001, 1, kNoStroke);
  EXPECT_TRUE(sink.hasMoved());
}

TEST(UnseenSinkEdges, WhatRoseIsNotDrivenDownWhenAnotherBehaviourHasIt) {
  UnseenSink sink = settledAt(20, kSteepDive);
  run(sink, 21, 20, kSteepLift);
  walk(sink, 20, 17.5, kNoPump);
  EXPECT_TRUE(sink.hasMoved());
  sink = settledAt(20, kSteepDive);
  run(sink, 20, 20, kSteepLift);
  walk(sink, 20, 17.5, kNoPump);
  EXPECT_FALSE(sink.hasMoved()) << "it may sink still";
  sink = settledAt(20, kSteepDive);
  run(sink, 20, 20, kNoPump);
  walk(sink, 20, 17.5, kNoPump);
  EXPECT_TRUE(sink.hasMoved()) << "it no longer does";
}

constexpr double kReachIn4S = kSteepSinkMps * 4 + 0.5;

TEST(UnseenSinkEdges, AStepThatNoVehicleMakesRestartsIt) {
  for (const bool too_far : {false, true}) {
    const double step = too_far ? std::nextafter(kReachIn4S, 9) : kReachIn4S;
    UnseenSink sink{kHull};
    sink.observe(0, 4, kNoPump);
    sink.observe(step, 4, kNoPump);
    sink.observe(3, 4, kNoPump);
    EXPECT_EQ(sink.hasMoved(), !too_far);
  }
}

TEST(UnseenSinkEdges, AGapOfMoreThanTwentySecondsRestartsIt) {
  for (const double gap : {20.0, 21.0}) {
    UnseenSink sink{kHull};
    sink.observe(20, 1, kNoPump);
    run(sink, 19, kUnread, kNoPump);
    sink.observe(29, gap - 19, kNoPump);  // as far as it may: and that is not roughness
    EXPECT_EQ(sink.hasMoved(), gap == 20) << gap;
  }
}

TEST(UnseenSinkEdges, WhatIsRoughMustGoFarther) {
  for (const double off : {0.05, 0.5}) {
    UnseenSink sink{kHull};
    for (int i = 0; i < 40; ++i) {
      sink.observe(20 + (i % 2 == 0 ? off : -off), 4, kNoPump);
    }
    sink.observe(21.5, 4, kNoPump);
    sink.observe(23, 4, kNoPump);
    EXPECT_EQ(sink.hasMoved(), off == 0.05) << off;
  }
}

TEST(UnseenSinkEdges, RoughnessCountsInRealTime) {
  UnseenSink sink{kHull};  // steadily down, with gaps that differ
  double depth = 20;
  for (const double gap : {4.0, 15.0, 4.0, 4.5, 16.0, 4.0, 15.0, 8.0}) {
    sink.observe(depth += 0.17 * gap, gap, kNoPump);
  }
  EXPECT_NEAR(sink.lateBy(), 0, 4) << "by the rare readings alone";
  EXPECT_TRUE(sink.hasMoved());
}

TEST(UnseenSinkEdges, AConfirmedDepthIsWhereItCountsFrom) {
  UnseenSink sink = settledAt(20, kSteepDive);
  sink.confirm(25);
  EXPECT_EQ(sink.shown(), 25);
  EXPECT_EQ(sink.deepest(), 25);
  EXPECT_EQ(sink.sunkSteeply(), 0);
  EXPECT_NEAR(sink.sunkInDive(), kSteepSinkMps, 1e-9);
  run(sink, 1, 20, kSteepDive);
  EXPECT_NEAR(sink.deepest(), 25 + kSteepSinkMps, 1e-9);
}

}  // namespace
}  // namespace glider::hooks
