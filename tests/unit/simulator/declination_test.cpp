// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The declination along a way against that of the model at every place.

#include "simulator/magnetism/declination.h"

#include "simulator/magnetism/magnetic_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

constexpr double kPiRad = std::numbers::pi;
constexpr double kRadPerDeg = kPiRad / 180;
constexpr double kKmPerDeg = 111.2;
constexpr double kYear = 2026.5;

/// The greatest difference from the model, rad, in `steps` steps of `step_km` on one course.
double worstOnTheWay(Declination& declination, double latitude, double longitude, double course,
                     double step_km, int steps) {
  double worst = 0;
  for (int step = 0; step < steps; ++step) {
    const double model = magneticField(latitude, longitude, 0, kYear).declination_rad;
    const double difference = declination.at(latitude, longitude) - model;
    worst = std::max(worst, std::fabs(std::remainder(difference, 2 * kPiRad)));
    latitude += step_km / kKmPerDeg * std::cos(course);
    longitude += step_km / kKmPerDeg * std::sin(course) / std::cos(latitude * kRadPerDeg);
    longitude = std::remainder(longitude, 360);
  }
  return worst;
}

TEST(Declination, IsThatOfTheModelAllOverTheEarth) {
  for (double latitude = -89; latitude <= 89; latitude += 8.9) {
    for (double longitude = -180; longitude < 180; longitude += 14.3) {
      for (const double course : {0.0, 1.1, 2.2, 3.3, 4.4, 5.5}) {
        Declination declination(kYear);
        EXPECT_LE(worstOnTheWay(declination, latitude, longitude, course, 0.013, 40),
                  Declination::kErrorRad)
            << latitude << ", " << longitude << ", course " << course;
      }
    }
  }
}

TEST(Declination, IsSeldomComputedWhereGlidersFly) {
  constexpr double kCycleKm = 0.0014;
  constexpr int kCycles = 1000;
  for (const double latitude : {-60.0, 0.0, 39.2, 60.0}) {
    Declination declination(kYear);
    worstOnTheWay(declination, latitude, -73.8, 1, kCycleKm, kCycles);
    EXPECT_LE(declination.computed(), kCycles / 20) << latitude;
    EXPECT_GT(declination.computed(), 1) << latitude;
  }
}

TEST(Declination, GoesOnAcrossTheDateLineAndIsRightAfterAJump) {
  Declination declination(kYear);
  (void)declination.at(10, 179.9999);
  EXPECT_LE(worstOnTheWay(declination, 10, 179.9999, kPiRad / 2, 0.002, 20),
            Declination::kErrorRad);
  EXPECT_EQ(declination.computed(), 1);
  const double elsewhere = magneticField(-40, -30, 0, kYear).declination_rad;
  EXPECT_EQ(declination.at(-40, -30), elsewhere);
  EXPECT_EQ(declination.computed(), 2);
}

/// North and east part of the horizontal field, nT.
struct Level {
  double north, east;
};

Level levelField(double latitude, double longitude, double year) {
  const MagneticField field = magneticField(latitude, longitude, 0, year);
  return {field.horizontal_nT * std::cos(field.declination_rad),
          field.horizontal_nT * std::sin(field.declination_rad)};
}

TEST(Declination, TheFieldIsNowhereSteeper) {
  constexpr double kStepDeg = 0.01;
  double steepest = 0;
  for (double latitude = -88; latitude <= 88; latitude += 2) {
    for (double longitude = -180; longitude < 180; longitude += 2) {
      for (const double year : {kFirstMagneticYear, kLastMagneticYear}) {
        const Level here = levelField(latitude, longitude, year);
        const Level north = levelField(latitude + kStepDeg, longitude, year);
        const Level east = levelField(latitude, longitude + kStepDeg, year);
        // True north turns on the way east; its turn is not the field's.
        const double turn = kStepDeg * kRadPerDeg * std::sin(latitude * kRadPerDeg);
        const double km = kStepDeg * kKmPerDeg;
        const double per_km =
            std::hypot(std::hypot(north.north - here.north, north.east - here.east) / km,
                       std::hypot(east.north - here.north + turn * here.east,
                                  east.east - here.east - turn * here.north) /
                           (km * std::cos(latitude * kRadPerDeg)));
        steepest = std::max(steepest, per_km);
      }
    }
  }
  EXPECT_LE(steepest, Declination::kSteepest_nT_per_km);
  EXPECT_GT(steepest, 0.8 * Declination::kSteepest_nT_per_km);
}

}  // namespace
}  // namespace glider::simulator
