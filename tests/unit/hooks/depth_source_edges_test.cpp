// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Where exactly each limit of one sensor of depth, and of the depths of the last 20 s, lies.

#include "hooks/hookbeh/depth_source.h"
#include "hooks/hookbeh/hull.h"
#include "hooks/hookbeh/recent_depths.h"
#include "tests/slocum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glider::hooks {
namespace {

using Reading = DepthSource::Reading;
constexpr double kNoReading = std::numeric_limits<double>::quiet_NaN();

Reading firstReading(double depth_m) {
  DepthSource source{kHull};
  source.observe(depth_m, 4);
  return source.reading();
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
    DepthSource source{kHull};
    source.observe(0, 4);
    DepthSource other = source;
    source.observe(way * reach, 4);
    EXPECT_EQ(source.reading(), Reading::Good) << way;
    other.observe(way * std::nextafter(reach, 9), 4);
    EXPECT_EQ(other.reading(), Reading::Jumped) << way;
  }
}

TEST(DepthSourceEdges, BeforeItsCadenceIsKnownAReadingMayHaveBeenKeptForLong) {
  DepthSource source{kHull};
  for (int i = 0; i < 8; ++i) {
    source.observe(2, 4);
  }
  source.observe(2.5 + 0.4 * 30, 4);
  EXPECT_EQ(source.reading(), Reading::Good);
}

TEST(DepthSourceEdges, AReadingThatJumpsCountsAsOneCycleHoweverLongItsCycleWas) {
  DepthSource source{kHull};
  source.observe(2, 4);
  source.observe(30, 15);
  EXPECT_EQ(source.jumpedFor(), 4);
}

TEST(DepthSourceEdges, AnOldDepthReachesFarther) {
  DepthSource source{kHull};
  source.observe(0, 4);
  source.observe(kNoReading, 4);
  EXPECT_EQ(source.reading(), Reading::Missing);
  EXPECT_EQ(source.age(), 4);
  source.observe(2.5 + 0.4 * 8, 4);
  EXPECT_EQ(source.reading(), Reading::Good);
  EXPECT_EQ(source.age(), 0);
}

TEST(DepthSourceEdges, ReadingsOfTheFirstMinuteAreNotKeptAfterAJump) {
  for (const int seconds : {59, 60}) {
    DepthSource source{kHull};
    for (int i = 0; i < seconds; ++i) {
      source.observe(10, 1);
    }
    source.observe(50, 1);
    EXPECT_EQ(source.reading(), Reading::Jumped);
    EXPECT_EQ(source.depth(), seconds < 60 ? 50 : 10) << seconds;
    EXPECT_EQ(source.age(), seconds < 60 ? 0 : 1) << seconds;
  }
}

TEST(DepthSourceEdges, GoodReadingsTakeHalfOfTheirTimeFromJumps) {
  DepthSource source{kHull};
  for (int i = 0; i < 60; ++i) {
    source.observe(10, 1);
  }
  source.observe(50, 4);
  source.observe(50.5, 1);
  EXPECT_EQ(source.jumpedFor(), 5);
  for (const double left : {4.5, 4.0, 3.5, 3.0, 2.5, 2.0, 1.5, 1.0, 0.5, 0.0, 0.0}) {
    source.observe(10, 1);
    EXPECT_EQ(source.jumpedFor(), left);
  }
  source.observe(50, 3);
  source.observe(kNoReading, 3);
  EXPECT_EQ(source.jumpedFor(), 3) << "one that is missing says nothing";
}

TEST(DepthSourceEdges, ReadingsAreTheSameOnlyIfAllBitsAre) {
  DepthSource source{kHull};
  source.observe(10, 4);
  EXPECT_EQ(source.sameFor(), 0);
  source.observe(10, 3);
  EXPECT_EQ(source.sameFor(), 3);
  source.observe(kNoReading, 3);
  EXPECT_EQ(source.sameFor(), 3);
  source.observe(10, 2);
  EXPECT_EQ(source.sameFor(), 5);
  source.observe(std::nextafter(10, 11), 2);
  EXPECT_EQ(source.sameFor(), 0);
}

TEST(RecentDepthsEdges, ADepthIsRecentForTwentySeconds) {
  RecentDepths recent;
  recent.observe(10, 4);
  recent.observe(kNoReading, 20);
  EXPECT_EQ(recent.distanceTo(12), 2);
  EXPECT_EQ(recent.distanceTo(7), 3);
  recent.observe(kNoReading, 1);
  EXPECT_TRUE(std::isnan(recent.distanceTo(10)));
}

TEST(RecentDepthsEdges, TheNewestTenCount) {
  RecentDepths recent;
  recent.observe(30, 1);
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(recent.distanceTo(30), 0) << i;
    recent.observe(10, 1);
  }
  EXPECT_EQ(recent.distanceTo(30), 0);
  recent.observe(10, 1);
  EXPECT_EQ(recent.distanceTo(30), 20);
  EXPECT_EQ(recent.distanceTo(10), 0);
}

}  // namespace
}  // namespace glider::hooks
