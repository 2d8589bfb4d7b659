// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Distance and bearing against GeographicLib's geodesics on a sphere.

#include "tests/unit/runtime/numbers_samples.h"

#include <GeographicLib/Geodesic.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider {
namespace {

using numbers_samples::Random;

constexpr double kRadius = 6371008.8;
constexpr double kHalfTurn = 3.14159265358979323846 * kRadius;

struct Course {
  double distance = 0;
  double bearing = 0;
};

struct Leg {
  double latitude;
  double longitude;
  double to_latitude;
  double to_longitude;
};

/// GeographicLib's own spherical result: metres, and rad in [0, 2 pi).
Course theirs(const Leg& leg) {
  static const GeographicLib::Geodesic sphere(kRadius, 0);
  double distance = 0;
  double degrees = 0;
  double end = 0;
  sphere.Inverse(leg.latitude, leg.longitude, leg.to_latitude, leg.to_longitude, distance, degrees,
                 end);
  return {distance, std::fmod(degrees + 360, 360) * M_PI / 180};
}

Course ours(const Leg& leg) {
  return {gliderDistance(leg.latitude, leg.longitude, leg.to_latitude, leg.to_longitude),
          gliderBearing(leg.latitude, leg.longitude, leg.to_latitude, leg.to_longitude)};
}

/// The bearing may be off by what a nanometre at the far end is seen as.
void expectSame(const Leg& leg) {
  const Course expected = theirs(leg);
  const Course found = ours(leg);
  const double scale = std::max(std::sin(expected.distance / kRadius) * kRadius, 1e-9);
  EXPECT_NEAR(found.distance, expected.distance, 5e-9 + 1e-15 * expected.distance)
      << leg.latitude << " " << leg.longitude << " " << leg.to_latitude << " " << leg.to_longitude;
  EXPECT_NEAR(std::remainder(found.bearing - expected.bearing, 2 * M_PI), 0, 1e-14 + 1e-8 / scale)
      << leg.latitude << " " << leg.longitude << " " << leg.to_latitude << " " << leg.to_longitude;
  EXPECT_GE(found.bearing, 0);
  EXPECT_LT(found.bearing, 2 * M_PI);
}

TEST(Earth, LegsOfEveryLengthAreGeographicLibs) {
  Random random(11);
  for (int i = 0; i < 50000; ++i) {
    const double latitude = random.between(-90, 90);
    const double longitude = random.between(-180, 180);
    expectSame({latitude, longitude, random.between(-90, 90), random.between(-180, 180)});
    const double near = std::clamp(latitude + random.spread(-28, -1), -90.0, 90.0);
    expectSame({latitude, longitude, near, longitude + random.spread(-28, -1)});
  }
}

/// The place `distance` m from a place at a bearing (degrees), by GeographicLib.
std::pair<double, double> theirEnd(double latitude, double longitude, double bearing,
                                   double distance) {
  static const GeographicLib::Geodesic sphere(kRadius, 0);
  std::pair<double, double> end;
  sphere.Direct(latitude, longitude, bearing, distance, end.first, end.second);
  return end;
}

TEST(Earth, PlacesAtABearingAndADistanceAreGeographicLibs) {
  Random random(17);
  constexpr double kNanometre = 1e-14;  // degrees
  for (int i = 0; i < 50000; ++i) {
    const double latitude = random.between(-89, 89);
    const double longitude = random.between(-180, 180);
    const double bearing = random.between(-360, 360);
    const double distance =
        i % 2 == 0 ? random.between(-kHalfTurn, kHalfTurn) : random.spread(-10, 20);
    const auto [north, east] = theirEnd(latitude, longitude, bearing, distance);
    const double radians = bearing * M_PI / 180;
    const double found = gliderOffsetLongitude(latitude, longitude, radians, distance);
    EXPECT_NEAR(gliderOffsetLatitude(latitude, longitude, radians, distance), north,
                20 * kNanometre);
    EXPECT_NEAR(std::remainder(found - east, 360) * std::cos(north * M_PI / 180), 0,
                20 * kNanometre)
        << latitude << " " << longitude << " " << bearing << " " << distance;
    EXPECT_LE(std::fabs(found), 180);
  }
}

TEST(Earth, PlacesAtABearingCrossPolesAndTheDateLine) {
  EXPECT_NEAR(gliderOffsetLatitude(89, 10, 0, kHalfTurn / 90), 89, 1e-12);
  EXPECT_NEAR(gliderOffsetLongitude(89, 10, 0, kHalfTurn / 90), -170, 1e-10);
  EXPECT_NEAR(gliderOffsetLongitude(0, 179, M_PI_2, kHalfTurn / 90), -179, 1e-12);
  EXPECT_NEAR(gliderOffsetLongitude(0, -179, -M_PI_2, kHalfTurn / 90), 179, 1e-12);
  EXPECT_DOUBLE_EQ(gliderOffsetLatitude(39, -74, 1, 0), 39);
  EXPECT_DOUBLE_EQ(gliderOffsetLongitude(39, -74, 1, 0), -74);
  EXPECT_NEAR(gliderOffsetLatitude(90, 0, 0, kHalfTurn / 180), 89, 1e-12);
}

TEST(Earth, NoPlaceAtABearingIsKnownFromNowhere) {
  EXPECT_TRUE(std::isnan(gliderOffsetLatitude(90.1, 0, 0, 1)));
  EXPECT_TRUE(std::isnan(gliderOffsetLatitude(39, NAN, 0, 1)));
  EXPECT_TRUE(std::isnan(gliderOffsetLongitude(39, -74, NAN, 1)));
  EXPECT_TRUE(std::isnan(gliderOffsetLongitude(39, -74, 0, NAN)));
  EXPECT_TRUE(std::isnan(gliderOffsetLongitude(39, -74, 0, kHalfTurn * 1.001)));
}

TEST(Earth, AntipodesKeepTheirDigits) {
  Random random(13);
  for (int i = 0; i < 1000; ++i) {
    const double latitude = random.between(-89, 89);
    const double longitude = random.between(-180, 180);
    const Leg leg{latitude, longitude, -latitude + random.spread(-20, -10),
                  longitude + 180 + random.spread(-20, -10)};
    EXPECT_NEAR(ours(leg).distance, theirs(leg).distance, 2e-8) << latitude << " " << longitude;
  }
  EXPECT_DOUBLE_EQ(gliderDistance(0, 0, 0, 180), kHalfTurn);
  EXPECT_DOUBLE_EQ(gliderDistance(90, 0, -90, 77), kHalfTurn);
}

TEST(Earth, TheAntimeridianIsAPlaceLikeAnyOther) {
  const double metres = gliderDistance(10, 179.75, 10, -179.75);
  EXPECT_DOUBLE_EQ(metres, gliderDistance(10, 0, 10, 0.5));
  EXPECT_EQ(metres, gliderDistance(10, -179.75, 10, 179.75));
  EXPECT_LT(std::fabs(gliderBearing(0, 179.75, 0, -179.75) - M_PI_2), 1e-15);
  EXPECT_LT(std::fabs(gliderBearing(0, -179.75, 0, 179.75) - 3 * M_PI_2), 1e-15);
  EXPECT_EQ(gliderDistance(10, 180, 10, -180), 0.0);
}

TEST(Earth, AtAPoleEveryLongitudeIsTheSamePlace) {
  EXPECT_EQ(gliderDistance(90, 12, 90, -140), 0.0);
  EXPECT_EQ(gliderDistance(-90, 0, -90, 99.5), 0.0);
  EXPECT_DOUBLE_EQ(gliderDistance(90, 12, 45, -140), kHalfTurn / 4);
  EXPECT_EQ(gliderBearing(45, 10, 90, 77), 0.0);
  EXPECT_EQ(gliderBearing(45, 10, -90, 77), M_PI);
  EXPECT_DOUBLE_EQ(gliderBearing(90, 0, 45, 30), M_PI * 150 / 180);
}

TEST(Earth, OneDegreeOfLatitudeIsAnArcOfTheMeanSphere) {
  EXPECT_DOUBLE_EQ(gliderDistance(39, -74, 40, -74), kHalfTurn / 180);
  EXPECT_EQ(gliderBearing(39, -74, 40, -74), 0.0);
  EXPECT_EQ(gliderBearing(40, -74, 39, -74), M_PI);
  EXPECT_EQ(gliderDistance(39, -74, 39, -74), 0.0);
}

TEST(Earth, WhatHasNoAnswerIsUnknown) {
  EXPECT_TRUE(std::isnan(gliderBearing(39, -74, 39, -74)));
  EXPECT_TRUE(std::isnan(gliderBearing(90, 0, 90, 55)));
  EXPECT_TRUE(std::isnan(gliderDistance(90.001, 0, 39, -74)));
  EXPECT_TRUE(std::isnan(gliderDistance(39, -360.5, 39, -74)));
  EXPECT_TRUE(std::isnan(gliderDistance(39, -74, NAN, -74)));
  EXPECT_TRUE(std::isnan(gliderBearing(39, -74, 39, INFINITY)));
}

}  // namespace
}  // namespace glider
