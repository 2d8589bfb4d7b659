// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Where exactly each limit of one sensor of depth, and of the depths of the last 20 s, lies.

#include "hooks/hookbeh/depth_source.h"
#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/recent_depths.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/begun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glider::hooks {
namespace {

using Reading = HookDepthReading;
constexpr double kNoReading = std::numeric_limits<double>::quiet_NaN();

Reading firstReading(double depth_m) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  hookDepthSourceObserve(&source, depth_m, 4);
  return source.reading;
}

TEST(DepthSourceEdges, ADepthIsOneFromFiveMetresAboveToHalfAsMuchAgainAsTheHullBears) {
  EXPECT_EQ(firstReading(-5), Reading::Good);
  EXPECT_EQ(firstReading(std::nextafter(-5, -6)), Reading::Missing);
  EXPECT_EQ(firstReading(300), Reading::Good);
  EXPECT_EQ(firstReading(std::nextafter(300, 301)), Reading::Missing);
  EXPECT_EQ(firstReading(kNoReading), Reading::Missing);
}

TEST(DepthSourceEdges, ItJumpsBeyondWhatTheVehicleMakesAndNoiseAdds) {
  const double reach = 2.5 + 0.4 * 4;
  for (const double way : {1.0, -1.0}) {
    HookDepthSource source = begun(hookDepthSourceInit, &kHull);
    hookDepthSourceObserve(&source, 0, 4);
    HookDepthSource other = source;
    hookDepthSourceObserve(&source, way * reach, 4);
    EXPECT_EQ(source.reading, Reading::Good) << way;
    hookDepthSourceObserve(&other, way * std::nextafter(reach, 9), 4);
    EXPECT_EQ(other.reading, Reading::Jumped) << way;
  }
}

TEST(DepthSourceEdges, BeforeItsCadenceIsKnownAReadingMayHaveBeenKeptForLong) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  for (int i = 0; i < 8; ++i) {
    hookDepthSourceObserve(&source, 2, 4);
  }
  hookDepthSourceObserve(&source, 2.5 + 0.4 * 30, 4);
  EXPECT_EQ(source.reading, Reading::Good);
}

TEST(DepthSourceEdges, AReadingThatJumpsCountsAsOneCycleHoweverLongItsCycleWas) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  hookDepthSourceObserve(&source, 2, 4);
  hookDepthSourceObserve(&source, 30, 15);
  EXPECT_EQ(source.jumped_s, 4);
}

TEST(DepthSourceEdges, AnOldDepthReachesFarther) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  hookDepthSourceObserve(&source, 0, 4);
  hookDepthSourceObserve(&source, kNoReading, 4);
  EXPECT_EQ(source.reading, Reading::Missing);
  EXPECT_EQ(source.age_s, 4);
  hookDepthSourceObserve(&source, 2.5 + 0.4 * 8, 4);
  EXPECT_EQ(source.reading, Reading::Good);
  EXPECT_EQ(source.age_s, 0);
}

TEST(DepthSourceEdges, ReadingsOfTheFirstMinuteAreNotKeptAfterAJump) {
  for (const int seconds : {59, 60}) {
    HookDepthSource source = begun(hookDepthSourceInit, &kHull);
    for (int i = 0; i < seconds; ++i) {
      hookDepthSourceObserve(&source, 10, 1);
    }
    hookDepthSourceObserve(&source, 50, 1);
    EXPECT_EQ(source.reading, Reading::Jumped);
    EXPECT_EQ(source.depth_m, seconds < 60 ? 50 : 10) << seconds;
    EXPECT_EQ(source.age_s, seconds < 60 ? 0 : 1) << seconds;
  }
}

TEST(DepthSourceEdges, GoodReadingsTakeHalfOfTheirTimeFromJumps) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  for (int i = 0; i < 60; ++i) {
    hookDepthSourceObserve(&source, 10, 1);
  }
  hookDepthSourceObserve(&source, 50, 4);
  hookDepthSourceObserve(&source, 50.5, 1);
  EXPECT_EQ(source.jumped_s, 5);
  for (const double left : {4.5, 4.0, 3.5, 3.0, 2.5, 2.0, 1.5, 1.0, 0.5, 0.0, 0.0}) {
    hookDepthSourceObserve(&source, 10, 1);
    EXPECT_EQ(source.jumped_s, left);
  }
  hookDepthSourceObserve(&source, 50, 3);
  hookDepthSourceObserve(&source, kNoReading, 3);
  EXPECT_EQ(source.jumped_s, 3) << "one that is missing says nothing";
}

TEST(DepthSourceEdges, ReadingsAreTheSameOnlyIfAllBitsAre) {
  HookDepthSource source = begun(hookDepthSourceInit, &kHull);
  hookDepthSourceObserve(&source, 10, 4);
  EXPECT_EQ(source.same_s, 0);
  hookDepthSourceObserve(&source, 10, 3);
  EXPECT_EQ(source.same_s, 3);
  hookDepthSourceObserve(&source, kNoReading, 3);
  EXPECT_EQ(source.same_s, 3);
  hookDepthSourceObserve(&source, 10, 2);
  EXPECT_EQ(source.same_s, 5);
  hookDepthSourceObserve(&source, std::nextafter(10, 11), 2);
  EXPECT_EQ(source.same_s, 0);
}

TEST(RecentDepthsEdges, ADepthIsRecentForTwentySeconds) {
  HookRecentDepths recent = begun(hookRecentDepthsInit);
  hookRecentDepthsObserve(&recent, 10, 4);
  hookRecentDepthsObserve(&recent, kNoReading, 20);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 12), 2);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 7), 3);
  hookRecentDepthsObserve(&recent, kNoReading, 1);
  EXPECT_TRUE(std::isnan(hookRecentDepthsDistanceTo(&recent, 10)));
}

TEST(RecentDepthsEdges, TheNewestTenCount) {
  HookRecentDepths recent = begun(hookRecentDepthsInit);
  hookRecentDepthsObserve(&recent, 30, 1);
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 30), 0) << i;
    hookRecentDepthsObserve(&recent, 10, 1);
  }
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 30), 0);
  hookRecentDepthsObserve(&recent, 10, 1);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 30), 20);
  EXPECT_EQ(hookRecentDepthsDistanceTo(&recent, 10), 0);
}

}  // namespace
}  // namespace glider::hooks
