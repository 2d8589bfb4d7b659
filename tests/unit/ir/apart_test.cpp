// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How far apart two areas are at least.

#include "ir/prove/geometry/apart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace glider::ir::prove {
namespace {

/// A box of 0.02 degrees.
Geofence box(double south, double west) {
  return {true,
          {{south, west}, {south, west + 0.02}, {south + 0.02, west + 0.02}, {south + 0.02, west}},
          0};
}

Geofence disc(double latitude, double longitude, double radius_m) {
  return {true, {{latitude, longitude}}, radius_m};
}

constexpr double kDegree_m = 6371008.8 * std::numbers::pi / 180;

TEST(LeastApart, OfTwoBoxesIsTheGapBetweenThem) {
  const double gap = leastApart({box(39, -74)}, {box(39.04, -74)});
  EXPECT_LE(gap, 0.02 * kDegree_m);
  EXPECT_GE(gap, 0.99 * 0.02 * kDegree_m);
  EXPECT_EQ(gap, leastApart({box(39.04, -74)}, {box(39, -74)}));
}

/// A degree of longitude is shorter at the latitude farther from the equator.
TEST(LeastApart, EastwardsIsNoLongerThanOnTheEarth) {
  for (const double latitude : {-60.0, -10.0, 0.0, 39.0, 70.0}) {
    const double gap = leastApart({box(latitude, -74)}, {box(latitude, -73.9)});
    const double farther = std::fabs(latitude) + (latitude < 0 ? 0 : 0.02);
    const double most = 0.08 * kDegree_m * std::cos(farther * std::numbers::pi / 180);
    EXPECT_LE(gap, most) << latitude;
    EXPECT_GE(gap, 0.8 * most) << latitude;
  }
}

TEST(LeastApart, OfDiscsIsWithoutTheirRadii) {
  const double gap = leastApart({disc(39, -74, 1000)}, {disc(39.1, -74, 2000)});
  EXPECT_LE(gap, 0.1 * kDegree_m - 3000);
  EXPECT_GE(gap, 0.1 * kDegree_m - 3200);
}

TEST(LeastApart, OfADiscAndABox) {
  const double gap = leastApart({disc(38.9, -73.99, 1000)}, {box(39, -74)});
  EXPECT_LE(gap, 0.1 * kDegree_m - 1000);
  EXPECT_GE(gap, 0.1 * kDegree_m - 1200);
}

TEST(LeastApart, IsNothingForAreasThatOverlapOrLieInEachOther) {
  EXPECT_EQ(leastApart({box(39, -74)}, {box(39.01, -74.01)}), 0);
  EXPECT_EQ(leastApart({disc(39, -74, 5000)}, {disc(39.01, -74, 100)}), 0);
  EXPECT_EQ(leastApart({disc(39.01, -73.99, 10)}, {box(39, -74)}), 0);
  EXPECT_EQ(leastApart({box(39, -74)}, {box(39.02, -74)}), 0) << "one edge";
}

TEST(LeastApart, CountsTheBestOfSeveralAreas) {
  EXPECT_GT(leastApart({disc(39, -74, 50000), box(39, -74)}, {box(39.04, -74)}), 2000);
  EXPECT_GT(leastApart({box(39, -74), disc(39, -74, 50000)}, {box(39.04, -74)}), 2000);
}

TEST(LeastApart, AnAreaToStayOutOfSaysNothing) {
  Geofence out = box(39.04, -74);
  out.keep_in = false;
  EXPECT_EQ(leastApart({box(39, -74)}, {out}), 0);
  EXPECT_EQ(leastApart({}, {box(39, -74)}), 0);
}

/// Even-odd, as the language has it: what a bow tie holds is in the hull of its corners.
TEST(LeastApart, OfAnAreaWhoseEdgesCrossIsThatOfItsHull) {
  const Geofence tie{true, {{39, -74}, {39.02, -73.98}, {39.02, -74}, {39, -73.98}}, 0};
  EXPECT_EQ(leastApart({tie}, {box(39.005, -74.05)}),
            leastApart({box(39, -74)}, {box(39.005, -74.05)}));
}

TEST(LeastApart, AcrossTheDateLineAndAtThePole) {
  EXPECT_GT(leastApart({box(10, 179.9)}, {box(10, -179.9)}), 10e3);
  EXPECT_LT(leastApart({box(10, 179.9)}, {box(10, -179.9)}), 25e3);
  EXPECT_EQ(leastApart({box(88, 10)}, {box(88, 20)}), 0) << "the map is not valid there";
}

}  // namespace
}  // namespace glider::ir::prove
