// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/geography/ddmm.h"
#include "simulator/seat/sensor_array.h"
#include "simulator/slocum/flight/navigator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

/// Dead reckoning and the data memory, in numbers computed by hand.
namespace glider::simulator {
namespace {

constexpr double kNoFix = std::numeric_limits<double>::quiet_NaN();
constexpr double kHalfTurn = std::numbers::pi;

TEST(Navigator, SpeedIsTheDepthRateOverTheSlope) {
  const LocalFrame frame(39, -73);
  Navigator n(frame);
  // Down at 0.18 m/s, nose down 26.57 degrees (slope 1:2): 0.36 m/s. Heading 30 degrees.
  n.reckon(0.18, -std::atan(0.5), kHalfTurn / 6, false, 4);
  EXPECT_NEAR(n.speed(), 0.36, 1e-12);
  EXPECT_NEAR(n.eastOfStart(), 0.72, 1e-12);
  EXPECT_NEAR(n.northOfStart(), 0.36 * 4 * std::sqrt(3) / 2, 1e-12);
  n.reckon(-0.09, std::atan(0.5), kHalfTurn, false, 4);
  EXPECT_NEAR(n.speed(), 0.18, 1e-12) << "climbs";
  EXPECT_NEAR(n.northOfStart(), 0.72 * std::sqrt(3) - 0.72, 1e-12);
}

/// Comet's u_angle_of_attack in a real log (2019-222-2-154): 0.040 rad at a pitch of 0.45, 0.046 at
/// 0.36, 0.034 at 0.60. Its curve is a little flatter than that of the steady flight.
TEST(Navigator, TheAngleOfAttackOfTheHullMakesTheGlideSteeper) {
  const LocalFrame frame(39, -73);
  const FlightCoefficients hull{.mass_kg = 65,
                                .reference_area_m2 = 0.1,
                                .drag = 0.15,
                                .induced_drag = 10.4926,
                                .wing_lift = 3.73427,
                                .hull_lift = 3.8};
  Navigator n(frame, hull);
  for (const auto& [pitch, attack] : {std::pair(0.45, 0.040), {0.36, 0.0465}, {0.60, 0.034}}) {
    n.reckon(-0.1, pitch, 0, false, 4);
    EXPECT_NEAR(std::atan(0.1 / n.speed()) - pitch, attack, 0.009) << "climbs at " << pitch;
    n.reckon(0.1, -pitch, 0, false, 4);
    EXPECT_NEAR(std::atan(0.1 / n.speed()) - pitch, attack, 0.009) << "dives at " << pitch;
  }
}

TEST(Navigator, ACurrentCarriesItAlong) {
  const LocalFrame frame(39, -73);
  Navigator n(frame);
  n.reckon(0.18, -std::atan(0.5), 0, false, 10, {0.2, -0.1});
  EXPECT_NEAR(n.eastOfStart(), 2, 1e-12);
  EXPECT_NEAR(n.northOfStart(), 3.6 - 1, 1e-12);
}

TEST(Navigator, PointsIntoTheCurrent) {
  const LocalFrame frame(39, -73);
  Navigator n(frame);
  n.reckon(0.15, -std::atan(0.5), 0, false, 4);  // 0.3 m/s
  EXPECT_NEAR(n.headingFor(0, {0.15, 0}), -kHalfTurn / 6, 1e-12)
      << "north, with water that goes east";
  EXPECT_NEAR(n.headingFor(0, {-0.15, 0}), kHalfTurn / 6, 1e-12);
  EXPECT_NEAR(n.headingFor(kHalfTurn / 2, {0, 0.15}), kHalfTurn / 2 + kHalfTurn / 6, 1e-12)
      << "east, going north";
  EXPECT_NEAR(n.headingFor(1, {0.2 * std::sin(1.0), 0.2 * std::cos(1.0)}), 1, 1e-12) << "along";
  EXPECT_NEAR(n.headingFor(0, {5, 0}), -kHalfTurn / 3, 1e-12) << "too strong: as far as it goes";
  n.reckon(0, 0, 0, true, 4);
  EXPECT_NEAR(n.headingFor(0, {0.15, 0}), -kHalfTurn / 6, 1e-12)
      << "afloat: with the usual 0.3 m/s";
}

/// A dive of 1000 s in water that moves 0.2 m/s east and 0.1 m/s south, then 40 s of drifting at
/// 0.5 m/s north until the first fix.
class EstimatedCurrent : public testing::Test {
 protected:
  void cycle(double until_s, bool at_surface, Planar drift, bool fixes) {
    for (; time_ < until_s; time_ += 4) {
      truth_ = {truth_.east + drift.east * 4, truth_.north + drift.north * 4};
      const Planar used = at_surface ? Planar{} : used_;
      reckoned_ = {reckoned_.east + used.east * 4, reckoned_.north + used.north * 4};
      const auto fix = fixes ? std::optional(truth_) : std::nullopt;
      estimate_.observe(time_, at_surface, reckoned_, fix, used);
      reckoned_ = fix.value_or(reckoned_);
    }
  }
  void dive(double seconds) { cycle(time_ + seconds, false, kWater, false); }

  static constexpr Planar kWater{0.2, -0.1}, kAfloat{0, 0.5};
  CurrentEstimate estimate_;
  Planar truth_{10, 20}, reckoned_{10, 20}, used_;
  double time_ = 0;
};

TEST_F(EstimatedCurrent, TheSecondFixTakesTheDriftAtTheSurfaceOutOfIt) {
  using State = CurrentEstimate::State;
  cycle(20, true, {}, true);
  EXPECT_EQ(estimate_.state(), State::MissionStart);
  dive(1000);
  EXPECT_EQ(estimate_.state(), State::UnderWater);
  EXPECT_FALSE(estimate_.current());
  cycle(time_ + 40, true, kAfloat, false);
  EXPECT_EQ(estimate_.state(), State::AwaitingFix);
  cycle(time_ + 4, true, kAfloat, true);
  EXPECT_EQ(estimate_.state(), State::AwaitingPostfix);
  ASSERT_TRUE(estimate_.current());
  EXPECT_NEAR(estimate_.current()->east, 0.2, 0.001);
  EXPECT_NEAR(estimate_.current()->north, -0.1 + 44 * 0.5 / 1000, 0.003) << "the first estimate";
  cycle(time_ + 56, true, kAfloat, true);
  EXPECT_EQ(estimate_.state(), State::AwaitingPostfix) << "56 s after the first";
  cycle(time_ + 4, true, kAfloat, true);
  EXPECT_EQ(estimate_.state(), State::AwaitingDive);
  EXPECT_NEAR(estimate_.current()->east, 0.2, 0.001);
  EXPECT_NEAR(estimate_.current()->north, -0.1, 0.003);
}

TEST_F(EstimatedCurrent, WhatWasUsedCounts) {
  cycle(20, true, {}, true);
  used_ = {0.15, 0};
  dive(1000);
  cycle(time_ + 4, true, {}, true);
  EXPECT_NEAR(estimate_.current()->east, 0.2, 0.001);
  EXPECT_NEAR(estimate_.current()->north, -0.1, 0.001);
}

TEST_F(EstimatedCurrent, ASurfacingWithoutAFixGoesOnWithTheDive) {
  cycle(20, true, {}, true);
  dive(1000);
  cycle(time_ + 12, true, kWater, false);
  dive(1000);
  cycle(time_ + 4, true, kWater, true);
  EXPECT_NEAR(estimate_.current()->east, 0.2, 0.001) << "over both, with the 12 s between";
}

TEST_F(EstimatedCurrent, ADiveThatIsTooShortSaysNothing) {
  cycle(20, true, {}, true);
  dive(116);
  cycle(time_ + 200, true, kAfloat, true);
  EXPECT_FALSE(estimate_.current());
  dive(124);
  cycle(time_ + 4, true, {}, true);
  EXPECT_TRUE(estimate_.current());
}

TEST(Navigator, KeepsTheSpeedWhereItCannotBeTold) {
  const LocalFrame frame(39, -73);
  Navigator n(frame);
  n.reckon(0.18, -std::atan(0.5), 0, false, 4);
  const double degree = kHalfTurn / 180;
  n.reckon(0.3, -10.9 * degree, 0, false, 4);
  EXPECT_NEAR(n.speed(), 0.36, 1e-12) << "too level";
  n.reckon(0.1, 0.5, 0, false, 4);
  EXPECT_NEAR(n.speed(), 0.36, 1e-12) << "sinks nose up: an inflection";
  n.reckon(0.41, -std::atan(0.5), 0, false, 4);
  EXPECT_NEAR(n.speed(), 0.36, 1e-12) << "0.82 m/s is not a flight";
  n.reckon(0.395, -std::atan(0.5), 0, false, 4);
  EXPECT_NEAR(n.speed(), 0.79, 1e-12);
  n.reckon(0.1, -11.1 * degree, 0, false, 4);
  EXPECT_NEAR(n.speed(), 0.1 / std::tan(11.1 * degree), 1e-12);
  n.reckon(0, -0.4, 0, false, 4);
  EXPECT_EQ(n.speed(), 0);
  n.reckon(kNoFix, -0.4, 0, false, 4);
  EXPECT_EQ(n.speed(), 0);
  n.reckon(0.18, -std::atan(0.5), 0, true, 4);
  EXPECT_EQ(n.speed(), 0) << "floats";
}

TEST(Navigator, AnUnknownHeadingIsTheLastOne) {
  const LocalFrame frame(39, -73);
  Navigator n(frame);
  n.reckon(0.18, -std::atan(0.5), kHalfTurn / 2, false, 4);
  n.reckon(0.18, -std::atan(0.5), kNoFix, false, 4);
  EXPECT_NEAR(n.eastOfStart(), 2 * 1.44, 1e-12);
  EXPECT_NEAR(n.northOfStart(), 0, 1e-12);
}

TEST(Navigator, AFixSetsItRight) {
  const LocalFrame frame(39, -73);
  Navigator n(frame);
  n.reckon(0.18, -std::atan(0.5), kHalfTurn / 2, false, 4);
  n.fix({-7, 8});
  EXPECT_EQ(n.eastOfStart(), -7);
  EXPECT_EQ(n.northOfStart(), 8);
}

TEST(Navigator, BearingsOfTheFourQuarters) {
  const LocalFrame frame(39, -73);
  Navigator n(frame);
  n.fix({100, -50});
  for (const double bearing : {0.1, 1.7, 3.3, 4.9, 6.2}) {
    const GeoPosition p =
        frame.position(100 + 800 * std::sin(bearing), -50 + 800 * std::cos(bearing));
    double distance = 0, found = 0;
    n.toWaypoint(toDdmm(p.latitude_deg), toDdmm(p.longitude_deg), distance, found);
    EXPECT_NEAR(distance, 800, 0.01);
    EXPECT_NEAR(found, bearing, 1e-5);
  }
  double distance = 0, bearing = 0;
  n.toWaypoint(kNoFix, -7300, distance, bearing);
  EXPECT_TRUE(std::isnan(distance));
}

TEST(LocalFrame, HasTheEllipsoidsMetres) {
  // WGS 84 at 39 degrees: 111,014.8 m a degree of latitude, 86,632 m one of longitude.
  const LocalFrame frame(39, -73);
  double x = 0, y = 0;
  frame.locate({39.01, -73}, x, y);
  EXPECT_NEAR(x, 0, 1e-6);
  EXPECT_NEAR(y, 1110.15, 0.1);
  frame.locate({39, -72.99}, x, y);
  EXPECT_NEAR(x, 866.3, 0.3);
  const GeoPosition back = frame.position(866.3, 1110.15);
  EXPECT_NEAR(back.latitude_deg, 39.01, 1e-5);
  EXPECT_NEAR(back.longitude_deg, -72.99, 1e-5);
}

platforms::Platform smallPlatform() {
  platforms::Platform platform;
  for (const int bytes : {8, 4, 1}) {
    platforms::PlatformSensor sensor;
    sensor.bytes = static_cast<uint8_t>(bytes);
    sensor.computer = bytes == 4 ? platforms::Computer::Science : platforms::Computer::Flight;
    platform.sensors.push_back(sensor);
  }
  return platform;
}

TEST(SensorArray, KeepsWhatTheWidthHolds) {
  SensorArray array(smallPlatform());
  EXPECT_TRUE(std::isnan(array.get(0)));
  array.set(0, 3910.123456789);
  EXPECT_EQ(array.get(0), 3910.123456789);
  array.set(1, 0.1);
  EXPECT_EQ(array.get(1), static_cast<double>(0.1F));
  for (const auto& [given, kept] : {std::pair{2.4, 2.0},
                                    {2.6, 3.0},
                                    {-2.6, -3.0},
                                    {126.6, 127.0},
                                    {300.0, 127.0},
                                    {-127.6, -128.0},
                                    {-300.0, -128.0}}) {
    array.set(2, given);
    EXPECT_EQ(array.get(2), kept) << given;
  }
  for (uint16_t id = 0; id < 3; ++id) {
    array.set(id, kNoFix);
    EXPECT_TRUE(std::isnan(array.get(id))) << id;
  }
}

TEST(SensorArray, KnowsWhatIsFreshAndWhose) {
  SensorArray array(smallPlatform());
  EXPECT_EQ(array.size(), 3);
  EXPECT_FALSE(array.fresh(0));
  array.set(0, 1);
  EXPECT_TRUE(array.fresh(0));
  EXPECT_FALSE(array.fresh(1));
  array.beginCycle();
  EXPECT_FALSE(array.fresh(0));
  EXPECT_EQ(array.get(0), 1);
  array.set(3, 7);  // a number that this vehicle does not have
  array.set(60000, 7);
  EXPECT_FALSE(array.ofScience(0));
  EXPECT_TRUE(array.ofScience(1));
  EXPECT_FALSE(array.ofScience(2));
}

}  // namespace
}  // namespace glider::simulator
