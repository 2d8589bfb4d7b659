// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a vehicle that is steered by RECON is given, and what is read from it:
// runtime/recon/README.md.

#include "runtime/recon/course.h"
#include "runtime/recon/readings.h"
#include "runtime/recon/vehicle_clock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::runtime::recon {
namespace {

using hooks::HookLateral;
using hooks::HookVertical;
using hooks::Instruction;

constexpr double kPi = 3.14159265358979323846;
constexpr Place kHere{41, -8.5};

GliderReconMission limits() {
  GliderReconMission mission{};
  mission.slowest_m_s = 0.8;
  mission.usual_m_s = 1.5;
  return mission;
}

Instruction dive() {
  Instruction instruction;
  instruction.vertical = HookVertical::Descend;
  instruction.lateral = HookLateral::Heading;
  instruction.depth_m = 20;
  instruction.pitch_rad = 1.2;
  instruction.heading_rad = 1;
  return instruction;
}

Goals goalsOf(const Course& course, double heading = 0.5, const Place& here = kHere) {
  Goals goals{-1, -1, -1};
  EXPECT_TRUE(course.goals(here, heading, goals));
  return goals;
}

Goals goalsFor(const Instruction& instruction, double heading = 0.5) {
  Course course(limits());
  course.steer(instruction, heading);
  return goalsOf(course, heading);
}

TEST(ReconCourse, ADiveHasItsDepthItsSpeedAndItsHeading) {
  const Goals goals = goalsFor(dive());
  EXPECT_EQ(goals.depth_m, 20);
  EXPECT_EQ(goals.speed_m_s, 1.2);
  EXPECT_NEAR(goals.heading_deg, 180 / kPi, 1e-9);
}

TEST(ReconCourse, HeadingsAreFrom0To360) {
  for (const auto& [heading, degrees] :
       {std::pair{0.0, 0.0}, {-kPi / 2, 270.0}, {kPi, 180.0}, {5 * kPi / 2, 90.0}, {-kPi, 180.0}}) {
    Instruction instruction = dive();
    instruction.heading_rad = heading;
    EXPECT_NEAR(goalsFor(instruction).heading_deg, degrees, 1e-9) << heading;
  }
}

TEST(ReconCourse, TheSurfaceIsDepth0AtTheUsualSpeed) {
  Instruction instruction = dive();
  instruction.vertical = HookVertical::Surface;
  EXPECT_EQ(goalsFor(instruction).depth_m, 0);
  EXPECT_EQ(goalsFor(instruction).speed_m_s, 1.5);
  instruction.vertical = HookVertical::Ascend;
  instruction.depth_m = 0.9;
  EXPECT_EQ(goalsFor(instruction).depth_m, 0);
  EXPECT_EQ(goalsFor(instruction).speed_m_s, 1.2);
  instruction.depth_m = 1;
  EXPECT_EQ(goalsFor(instruction).depth_m, 1);
}

TEST(ReconCourse, WithoutACommandItIsTheSurfaceAheadAndSlowly) {
  Course course(limits());
  const Goals goals = goalsOf(course);
  EXPECT_EQ(goals.depth_m, 0);
  EXPECT_EQ(goals.speed_m_s, 0.8);
  EXPECT_NEAR(goals.heading_deg, 0.5 * 180 / kPi, 1e-9);
  course.steer(dive(), 0.5);
  course.surface();
  EXPECT_EQ(goalsOf(course).depth_m, 0);
  EXPECT_EQ(goalsOf(course).speed_m_s, 0.8);
}

TEST(ReconCourse, AWaypointIsAHeadingFromWhereTheVehicleIs) {
  Instruction instruction = dive();
  instruction.lateral = HookLateral::Waypoint;
  instruction.latitude_ddmm = 4100.0;
  instruction.longitude_ddmm = -829.0;
  Course course(limits());
  course.steer(instruction, 0.5);
  EXPECT_NEAR(goalsOf(course).heading_deg, 90, 0.02);
  EXPECT_NEAR(goalsOf(course, 0.5, {41.01, -8.5 + 1.0 / 60}).heading_deg, 180, 0.02);
  EXPECT_NEAR(goalsOf(course, 0.5, Place()).heading_deg, 0.5 * 180 / kPi, 1e-9) << "unknown: ahead";
}

/// With each command that drifts, not with each turn of the vehicle.
TEST(ReconCourse, DriftKeepsTheHeadingOfItsFirstCommand) {
  Instruction instruction = dive();
  instruction.lateral = HookLateral::Drift;
  Course course(limits());
  course.steer(instruction, 1);
  EXPECT_NEAR(goalsOf(course, 2).heading_deg, 180 / kPi, 1e-9);
  instruction.depth_m = 30;
  course.steer(instruction, 2);
  EXPECT_NEAR(goalsOf(course, 2).heading_deg, 180 / kPi, 1e-9);
  course.steer(dive(), 2);
  course.steer(instruction, 2);
  EXPECT_NEAR(goalsOf(course, 3).heading_deg, 2 * 180 / kPi, 1e-9);
  course.surface();
  course.steer(instruction, 3);
  EXPECT_NEAR(goalsOf(course, 4).heading_deg, 3 * 180 / kPi, 1e-9);
}

TEST(ReconCourse, WithoutAHeadingNothingIsGiven) {
  Course course(limits());
  Goals goals;
  EXPECT_FALSE(course.goals(kHere, std::nan(""), goals));
  Instruction instruction = dive();
  instruction.lateral = HookLateral::Drift;
  course.steer(instruction, std::nan(""));
  EXPECT_FALSE(course.goals(kHere, std::nan(""), goals));
  EXPECT_TRUE(course.goals(kHere, 1, goals));
  course.steer(dive(), std::nan(""));
  EXPECT_TRUE(course.goals(kHere, std::nan(""), goals));
}

TEST(ReconClock, TakesTheDateFromTheFirstAnswer) {
  VehicleClock clock;
  EXPECT_TRUE(std::isnan(clock.timeOf(100)));
  clock.set(5);
  EXPECT_TRUE(std::isnan(clock.timeOf(100))) << "a computer that does not know the time";
  constexpr double kDay = 86400.0 * 20000;
  clock.set(kDay + 3600);
  EXPECT_EQ(clock.timeOf(3605.5), kDay + 3605.5);
  clock.set(kDay + 86400 * 7);
  EXPECT_EQ(clock.timeOf(3606.5), kDay + 3606.5);
  EXPECT_TRUE(std::isnan(clock.timeOf(std::nan(""))));
  EXPECT_EQ(clock.timeOf(3607.5), kDay + 3607.5);
}

TEST(ReconClock, GoesOnOverMidnightInBothDirections) {
  constexpr double kDay = 86400.0 * 20000;
  VehicleClock clock;
  clock.set(kDay - 1);
  EXPECT_EQ(clock.timeOf(86399.5), kDay - 0.5);
  EXPECT_EQ(clock.timeOf(0.5), kDay + 0.5);
  EXPECT_EQ(clock.timeOf(86399.9), kDay - 0.1) << "one that was overtaken";
  EXPECT_EQ(clock.timeOf(1), kDay + 1);
  EXPECT_EQ(clock.timeOf(43200), kDay + 43200);
  EXPECT_EQ(clock.timeOf(86399), kDay + 86399);
  EXPECT_EQ(clock.timeOf(2), kDay + 86402);
}

TEST(ReconReadings, HaveTheUnitsOfMissions) {
  hooks::recon::State state;
  state.latitude_deg = -41.5;
  state.longitude_deg = 8.25;
  state.depth_m = 12;
  state.depth_goal_m = 13;
  state.altitude_m = 30;
  state.pitch_deg = -10;
  state.roll_deg = 5;
  state.rpm = 1000;
  state.rpm_goal = 1100;
  state.speed_m_s = 1.5;
  state.heading_deg = 270;
  state.heading_rate_deg_s = -2;
  state.heading_goal_deg = -90;
  state.mode = 13;
  state.leg = 4;
  Readings readings;
  readings.take(state, 1.7e9);
  hooks::recon::Ctd ctd;
  ctd.temperature_degC = 14;
  ctd.salinity = 35;
  ctd.depth_m = 12.5;
  ctd.sound_speed_m_s = 1500;
  readings.take(ctd);
  const auto expect = [&](Reading reading, double value) {
    EXPECT_NEAR(readings.value(reading), value, 1e-9) << static_cast<int>(reading);
    double reported = -1;
    EXPECT_TRUE(readings.takeReport(reading, &reported));
    EXPECT_NEAR(reported, value, 1e-9);
    EXPECT_FALSE(readings.takeReport(reading, &reported)) << "taken once";
  };
  expect(Reading::Clock, 1.7e9);
  expect(Reading::Latitude, -4130);
  expect(Reading::Longitude, 815);
  expect(Reading::Depth, 12);
  expect(Reading::DepthGoal, 13);
  expect(Reading::Altitude, 30);
  expect(Reading::Pitch, -kPi / 18);
  expect(Reading::Roll, kPi / 36);
  expect(Reading::Rpm, 1000);
  expect(Reading::RpmGoal, 1100);
  expect(Reading::Speed, 1.5);
  expect(Reading::Heading, 1.5 * kPi);
  expect(Reading::HeadingRate, -kPi / 90);
  expect(Reading::HeadingGoal, 1.5 * kPi);
  expect(Reading::Mode, 13);
  expect(Reading::Leg, 4);
  expect(Reading::Temperature, 14);
  expect(Reading::Salinity, 35);
  expect(Reading::CtdDepth, 12.5);
  expect(Reading::SoundSpeed, 1500);
  EXPECT_EQ(readings.here().latitude, -41.5);
  EXPECT_EQ(readings.here().longitude, 8.25);
}

hooks::recon::State stateOf(double latitude_deg, double depth_m) {
  hooks::recon::State state;
  state.latitude_deg = latitude_deg;
  state.longitude_deg = 8.25;
  state.depth_m = depth_m;
  return state;
}

TEST(ReconReadings, TheDepthNowIsThatOfTheNewestState) {
  Readings readings;
  EXPECT_TRUE(std::isnan(readings.depthNow()));
  readings.take(stateOf(41, 0.5), 1.7e9);
  EXPECT_EQ(readings.depthNow(), 0.5);
  readings.take(stateOf(41, std::nan("")), 1.7e9 + 1);
  EXPECT_TRUE(std::isnan(readings.depthNow()));
}

TEST(ReconReadings, APlaceThatStatesLackFor10SecondsIsUnknown) {
  Readings readings;
  readings.take(stateOf(41, 0), 1.7e9);
  readings.take(stateOf(std::nan(""), 0), 1.7e9 + 9.5);
  EXPECT_EQ(readings.here().latitude, 41);
  readings.take(stateOf(std::nan(""), 0), 1.7e9 + 10);
  EXPECT_TRUE(std::isnan(readings.here().latitude));
  EXPECT_TRUE(std::isnan(readings.here().longitude));
  readings.take(stateOf(42, 0), 1.7e9 + 11);
  EXPECT_EQ(readings.here().latitude, 42);
  readings.take(stateOf(std::nan(""), 0), 1.7e9 - 1000);
  EXPECT_TRUE(std::isnan(readings.here().latitude)) << "a clock that was set back";
}

TEST(ReconReadings, WhatIsUnknownIsNotReported) {
  Readings readings;
  readings.take(hooks::recon::State(), 1.7e9);
  readings.take(hooks::recon::Ctd());
  double value = 0;
  for (uint32_t i = 0; i < kReadings; ++i) {
    const auto reading = static_cast<Reading>(i);
    EXPECT_EQ(readings.takeReport(reading, &value),
              reading == Reading::Clock || reading == Reading::Mode);
  }
  hooks::recon::State state;
  state.latitude_deg = 41;  // without a longitude
  state.heading_deg = 360;
  state.heading_goal_deg = 361;
  readings.take(state, 1.7e9);
  EXPECT_FALSE(readings.takeReport(Reading::Latitude, &value));
  EXPECT_TRUE(std::isnan(readings.here().latitude));
  EXPECT_EQ(readings.value(Reading::Heading), 0);
  EXPECT_FALSE(readings.takeReport(Reading::HeadingGoal, &value));
}

}  // namespace
}  // namespace glider::runtime::recon
