// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The Reference of each command (runtime/imc/README.md, M6 and M7), against
// GeographicLib.

#include "runtime/imc/course.h"
#include "tests/unit/runtime/imc_packets.h"

#include <GeographicLib/Geodesic.hpp>

#include <cmath>

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;
using hooks::HookLateral;
using hooks::HookVertical;
using hooks::Instruction;
using testing::kDegree;
using testing::kImcLimits;

constexpr Place kPorto{41.18, -8.71}, kSouth{-54.5, 179.995}, kNorth{69.5, 18.9};

Instruction headingOf(double degrees, double depth_m = 20, double speed = 1.3) {
  Instruction instruction;
  instruction.vertical = HookVertical::Descend;
  instruction.lateral = HookLateral::Heading;
  instruction.depth_m = depth_m;
  instruction.pitch_rad = speed;
  instruction.heading_rad = degrees * kDegree;
  return instruction;
}

Place placeOf(const Reference& reference) {
  return {reference.lat / kDegree, reference.lon / kDegree};
}

struct Leg {
  double metres = 0, azimuth_deg = 0;
};
Leg legTo(const Place& from, const Place& to) {
  Leg leg;
  double azimuth_there;
  GeographicLib::Geodesic::WGS84().Inverse(from.latitude, from.longitude, to.latitude, to.longitude,
                                           leg.metres, leg.azimuth_deg, azimuth_there);
  return leg;
}
Place along(const Place& from, double azimuth_deg, double metres) {
  Place to;
  GeographicLib::Geodesic::WGS84().Direct(from.latitude, from.longitude, azimuth_deg, metres,
                                          to.latitude, to.longitude);
  return to;
}

Reference told(Course& course, const Place& here) {
  Reference reference;
  EXPECT_TRUE(course.reference(here, reference));
  EXPECT_EQ(reference.flags, ReferenceFlag::Location | ReferenceFlag::Speed | ReferenceFlag::Z);
  EXPECT_TRUE(reference.speed.present);
  EXPECT_TRUE(reference.z.present);
  EXPECT_EQ(reference.z.value.z_units, ZUnits::Depth);
  EXPECT_EQ(reference.speed.value.speed_units, SpeedUnits::MetresPerSecond);
  return reference;
}

/// DUNE ends the plan 5 s after it has arrived, if it was given other depths and no other place.
TEST(ImcCourse, AFixedPlaceIsAnotherOneWhenTheVehicleArrives) {
  for (const Place& there : {kPorto, kSouth, kNorth}) {
    Course course(kImcLimits);
    Instruction command = headingOf(0);
    command.lateral = HookLateral::Waypoint;
    command.latitude_ddmm = ddmmOf(there.latitude);
    command.longitude_ddmm = ddmmOf(there.longitude);
    course.steer(command, along(there, 90, 100), 1);
    const Reference first = told(course, along(there, 90, 100));
    for (const auto& [metres, another] : {std::pair{30.0, false},
                                          {14.5, false},
                                          {13.5, true},
                                          {2.0, true},
                                          {19.5, true},
                                          {20.5, false},
                                          {15.0, false},
                                          {13.0, true}}) {
      const Reference now = told(course, along(there, 90, metres));
      EXPECT_EQ(now.lat != first.lat, another) << metres;
      EXPECT_EQ(now.lon, first.lon);
      EXPECT_LT(legTo(placeOf(now), placeOf(first)).metres, 0.01);
    }
    command.latitude_ddmm = ddmmOf(along(there, 0, 18).latitude);
    course.steer(command, there, 1);
    EXPECT_NEAR(legTo(there, placeOf(told(course, there))).metres, 18, 0.001)
        << "exactly: it has not arrived at the next place";
  }
}

/// DUNE counts only what is within 15 m as near: another depth beyond makes it forget its path, and
/// the place that it was given before.
TEST(ImcCourse, AnotherDepthOnTheWayOutIsFollowedByAnotherPlaceOnTheWayBack) {
  Course course(kImcLimits);
  Instruction command = headingOf(0);
  command.lateral = HookLateral::Waypoint;
  command.latitude_ddmm = ddmmOf(kPorto.latitude);
  command.longitude_ddmm = ddmmOf(kPorto.longitude);
  course.steer(command, along(kPorto, 90, 100), 1);
  const Reference first = told(course, along(kPorto, 90, 100));
  EXPECT_NE(told(course, along(kPorto, 90, 13)).lat, first.lat);
  const auto changesDepth = [&](double metres) {
    const double before = told(course, along(kPorto, 90, 17)).lat;
    EXPECT_NE(before, first.lat) << "the same command again, " << metres;
    course.steer(command, along(kPorto, 90, 17), 1);
    EXPECT_EQ(told(course, along(kPorto, 90, 17)).lat, first.lat) << metres;
    EXPECT_EQ(told(course, along(kPorto, 90, 14.5)).lat, first.lat) << metres;
    EXPECT_NE(told(course, along(kPorto, 90, 13.5)).lat, first.lat) << metres;
  };
  course.steer(command, along(kPorto, 90, 17), 1);
  EXPECT_NE(told(course, along(kPorto, 90, 17)).lat, first.lat) << "nothing has changed";
  command.depth_m = 30;
  changesDepth(30);
  command.vertical = HookVertical::Surface;
  changesDepth(0);
  command.vertical = HookVertical::Ascend;
  command.depth_m = 10;
  changesDepth(10);
}

TEST(ImcCourse, AHeadingIsAPlaceTwoKilometresAhead) {
  for (const Place& here : {kPorto, kSouth, kNorth}) {
    for (int degrees = 0; degrees < 360; degrees += 15) {
      Course course(kImcLimits);
      course.steer(headingOf(degrees), here, 1);
      const Leg leg = legTo(here, placeOf(told(course, here)));
      EXPECT_NEAR(leg.metres, 2000, 1) << here.latitude << " " << degrees;
      EXPECT_NEAR(std::remainder(leg.azimuth_deg - degrees, 360), 0, 0.05)
          << here.latitude << " " << degrees;
    }
  }
}

TEST(ImcCourse, ThePlaceStaysWhileTheLegLastsAndMovesAtFiveHundredMetres) {
  Course course(kImcLimits);
  course.steer(headingOf(70), kPorto, 0);
  const Place first = placeOf(told(course, kPorto));
  Place here = kPorto;
  for (double flown_m = 0; flown_m < 1400; flown_m += 100) {
    // The current takes it to the side, and the mission says the same again.
    here = along(along(kPorto, 70, flown_m), 160, flown_m / 10);
    course.steer(headingOf(70, 20 + flown_m / 100), here, 0.3);
    const Place place = placeOf(told(course, here));
    EXPECT_EQ(place.latitude, first.latitude) << flown_m;
    EXPECT_EQ(place.longitude, first.longitude) << flown_m;
  }
  here = along(first, 250, 495);
  const Leg moved = legTo(here, placeOf(told(course, here)));
  EXPECT_NEAR(moved.metres, 2000, 1);
  EXPECT_NEAR(moved.azimuth_deg, 70, 0.05);
  here = along(first, 250, 505);
  Course other(kImcLimits);
  other.steer(headingOf(70), kPorto, 0);
  EXPECT_EQ(placeOf(told(other, here)).latitude, first.latitude) << "not yet";
}

TEST(ImcCourse, AnotherHeadingIsANewLeg) {
  Course course(kImcLimits);
  course.steer(headingOf(70), kPorto, 0);
  const Place here = along(kPorto, 70, 300);
  course.steer(headingOf(71), here, 0);
  const Leg leg = legTo(here, placeOf(told(course, here)));
  EXPECT_NEAR(leg.metres, 2000, 1);
  EXPECT_NEAR(leg.azimuth_deg, 71, 0.05);
}

TEST(ImcCourse, AHeadingBeforeTheFirstPositionIsFlownFromIt) {
  Course course(kImcLimits);
  course.steer(headingOf(200), {}, 0);
  Reference reference;
  EXPECT_FALSE(course.reference({}, reference)) << "without a place it would be ignored";
  const Leg leg = legTo(kPorto, placeOf(told(course, kPorto)));
  EXPECT_NEAR(leg.metres, 2000, 1);
  EXPECT_NEAR(leg.azimuth_deg, -160, 0.05);
}

TEST(ImcCourse, AWaypointIsItsPlace) {
  Course course(kImcLimits);
  Instruction instruction = headingOf(0);
  instruction.lateral = HookLateral::Waypoint;
  instruction.latitude_ddmm = 4112.5;
  instruction.longitude_ddmm = -844.25;
  course.steer(instruction, kPorto, 1);
  for (const Place& here : {kPorto, Place{41.2081, -8.7375}, kSouth}) {
    const Place place = placeOf(told(course, here));
    EXPECT_NEAR(place.latitude, 41 + 12.5 / 60, 1e-9);
    EXPECT_NEAR(place.longitude, -(8 + 44.25 / 60), 1e-9);
  }
  instruction.longitude_ddmm = -844.5;
  course.steer(instruction, kPorto, 1);
  EXPECT_NEAR(placeOf(told(course, kPorto)).longitude, -(8 + 44.5 / 60), 1e-9);
}

TEST(ImcCourse, DriftKeepsTheHeadingThatItHad) {
  Course course(kImcLimits);
  Instruction instruction = headingOf(123);
  instruction.lateral = HookLateral::Drift;
  course.steer(instruction, kPorto, 300 * kDegree);
  course.steer(instruction, kPorto, 10 * kDegree);
  const Leg leg = legTo(kPorto, placeOf(told(course, kPorto)));
  EXPECT_NEAR(leg.azimuth_deg, -60, 0.05) << "not that of a later moment, nor a field without use";
  EXPECT_NEAR(leg.metres, 2000, 1);
  Course unknown(kImcLimits);
  unknown.steer(instruction, kPorto, std::nan(""));
  EXPECT_NEAR(legTo(kPorto, placeOf(told(unknown, kPorto))).metres, 0, 0.01)
      << "where it is, while no heading is known";
}

TEST(ImcCourse, DepthAndSpeedAreThoseOfTheCommand) {
  for (const HookVertical vertical : {HookVertical::Descend, HookVertical::Ascend}) {
    for (const double depth_m : {-1.0, -0.001, 0.0, 0.5, 20.0, 50.0}) {
      Course course(kImcLimits);
      Instruction instruction = headingOf(0, depth_m, 0.9);
      instruction.vertical = vertical;
      course.steer(instruction, kPorto, 0);
      const Reference reference = told(course, kPorto);
      EXPECT_EQ(reference.z.value.value, depth_m >= 1 ? static_cast<float>(depth_m) : 0.0F);
      EXPECT_FALSE(std::signbit(reference.z.value.value));
      EXPECT_EQ(reference.speed.value.value, 0.9);
    }
  }
}

TEST(ImcCourse, TheSurfaceIsDepthZeroAtTheUsualSpeed) {
  Course course(kImcLimits);
  Instruction instruction = headingOf(90, 20, 0);
  instruction.vertical = HookVertical::Surface;
  course.steer(instruction, kPorto, 0);
  const Reference reference = told(course, kPorto);
  EXPECT_EQ(reference.z.value.value, 0);
  EXPECT_EQ(reference.speed.value.value, 1.2);
  EXPECT_NEAR(legTo(kPorto, placeOf(reference)).azimuth_deg, 90, 0.05) << "on its heading";
}

TEST(ImcCourse, WithoutACommandItComesUpWhereItIs) {
  Course course(kImcLimits);
  for (const bool after : {false, true}) {
    if (after) {
      course.steer(headingOf(90), kPorto, 0);
      course.surface();
    }
    for (const Place& here : {kPorto, kSouth}) {
      const Reference reference = told(course, here);
      EXPECT_EQ(reference.z.value.value, 0);
      EXPECT_EQ(reference.speed.value.value, 1.2);
      EXPECT_NEAR(legTo(here, placeOf(reference)).metres, 0, 0.01);
    }
  }
  course.steer(headingOf(90), kSouth, 0);
  EXPECT_NEAR(legTo(kSouth, placeOf(told(course, kSouth))).metres, 2000, 1)
      << "the same heading again is a new leg";
}

}  // namespace
}  // namespace glider::runtime::imc
