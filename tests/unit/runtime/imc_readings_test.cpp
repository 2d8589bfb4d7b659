// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a vehicle reports, in the units of runtime/imc/readings.def.

#include "runtime/front_seat/position.h"
#include "runtime/imc/readings.h"
#include "tests/unit/runtime/imc_packets.h"

#include <GeographicLib/Ellipsoid.hpp>

#include <cmath>
#include <limits>

namespace glider::runtime::imc {
namespace {

using namespace hooks::imc;
using testing::give;
using testing::kDegree;

EstimatedState someState() {
  EstimatedState state;
  state.lat = 41.18 * kDegree;
  state.lon = -8.71 * kDegree;
  state.phi = 0.125F;
  state.theta = -0.25F;
  state.psi = 1.5F;
  state.u = 1.25F;
  state.vz = 0.375F;
  state.depth = 12.5F;
  state.alt = 7.25F;
  return state;
}

/// The only new value of what has been given since the last look; fails if another was reported.
double onlyReport(Readings& readings, Reading of) {
  double value = std::nan("");
  for (uint32_t i = 0; i < kReadings; ++i) {
    const auto reading = static_cast<Reading>(i);
    double reported;
    const bool fresh = readings.takeReport(reading, &reported);
    if (reading == of) {
      EXPECT_TRUE(fresh);
      value = reported;
    } else {
      EXPECT_EQ(fresh, reading == Reading::Clock) << i;
    }
  }
  return value;
}

template <typename Message>
double reportOf(Message message, Reading reading, double value) {
  Readings readings;
  message.value = static_cast<decltype(message.value)>(value);
  give(message, 1.7e9, readings);
  return onlyReport(readings, reading);
}

TEST(ImcReadings, NothingIsKnownBeforeItIsReported) {
  Readings readings;
  for (uint32_t i = 0; i < kReadings; ++i) {
    double value;
    EXPECT_TRUE(std::isnan(readings.value(static_cast<Reading>(i))));
    EXPECT_FALSE(readings.takeReport(static_cast<Reading>(i), &value));
  }
  EXPECT_TRUE(std::isnan(readings.latitude()));
}

TEST(ImcReadings, MessagesOfOneValue) {
  EXPECT_EQ(reportOf(Temperature(), Reading::Temperature, 12.5), 12.5);
  EXPECT_EQ(reportOf(Salinity(), Reading::Salinity, 35.25), 35.25);
  EXPECT_EQ(reportOf(Conductivity(), Reading::Conductivity, 4.25), 4.25);
  EXPECT_NEAR(reportOf(Pressure(), Reading::Pressure, 2500), 2.5, 1e-12) << "hPa to bar";
  EXPECT_EQ(reportOf(FuelLevel(), Reading::FuelLevel, 81.5), 81.5);
  EXPECT_EQ(reportOf(Voltage(), Reading::Voltage, 25.5), 25.5);
  EXPECT_EQ(reportOf(Rpm(), Reading::Rpm, -900), -900);
  EXPECT_EQ(reportOf(Chlorophyll(), Reading::Chlorophyll, 1.5), 1.5);
  EXPECT_EQ(reportOf(Turbidity(), Reading::Turbidity, 3.5), 3.5);
  EXPECT_EQ(reportOf(DissolvedOxygen(), Reading::Oxygen, 250), 250);
}

TEST(ImcReadings, TheMediumAndTheWater) {
  Readings readings;
  VehicleMedium medium;
  medium.medium = Medium::UnderWater;
  give(medium, 1.7e9, readings);
  EXPECT_EQ(onlyReport(readings, Reading::Medium), Medium::UnderWater);
  EstimatedStreamVelocity water;
  water.x = 0.25;
  water.y = -0.5;
  give(water, 1.7e9 + 1, readings);
  EXPECT_EQ(readings.value(Reading::CurrentNorth), 0.25);
  EXPECT_EQ(readings.value(Reading::CurrentEast), -0.5);
  EXPECT_EQ(readings.value(Reading::Clock), 1.7e9 + 1);
}

TEST(ImcReadings, TheState) {
  Readings readings;
  give(someState(), 1.7e9 + 0.5, readings);
  const std::pair<Reading, double> expected[] = {
      {Reading::Clock, 1.7e9 + 0.5}, {Reading::Depth, 12.5}, {Reading::DepthRate, 0.375},
      {Reading::Altitude, 7.25},     {Reading::Roll, 0.125}, {Reading::Pitch, -0.25},
      {Reading::Heading, 1.5},       {Reading::Speed, 1.25}};
  for (const auto& [reading, value] : expected) {
    double reported = 0;
    EXPECT_TRUE(readings.takeReport(reading, &reported));
    EXPECT_EQ(reported, value) << static_cast<int>(reading);
    EXPECT_FALSE(readings.takeReport(reading, &reported)) << "once";
  }
  EXPECT_NEAR(readings.value(Reading::Latitude), 4110.8, 1e-6);
  EXPECT_NEAR(readings.value(Reading::Longitude), -842.6, 1e-6);
}

TEST(ImcReadings, AnAltitudeOfMinusOneIsUnknown) {
  Readings readings;
  EstimatedState state = someState();
  state.alt = -1;
  give(state, 1.7e9, readings);
  EXPECT_TRUE(std::isnan(readings.value(Reading::Altitude)));
  state.alt = 0;
  give(state, 1.7e9, readings);
  EXPECT_EQ(readings.value(Reading::Altitude), 0);
  state.alt = -1;
  give(state, 1.7e9, readings);
  double value;
  EXPECT_TRUE(readings.takeReport(Reading::Altitude, &value));
  EXPECT_EQ(value, 0) << "the old one, which will be stale";
}

TEST(ImcReadings, HeadingsAreFromZeroToAWholeTurn) {
  for (const auto& [psi, heading] : {std::pair{0.0F, 0.0},
                                     {-0.0F, 0.0},
                                     {3.0F, 3.0},
                                     {-3.0F, 2 * M_PI - 3},
                                     {-1.5F, 2 * M_PI - 1.5},
                                     {-1e-30F, 0.0},
                                     {6.25F, 6.25}}) {
    Readings readings;
    EstimatedState state = someState();
    state.psi = psi;
    give(state, 1.7e9, readings);
    EXPECT_NEAR(readings.value(Reading::Heading), heading, 1e-6) << psi;
    EXPECT_GE(readings.value(Reading::Heading), 0) << psi;
    EXPECT_LT(readings.value(Reading::Heading), 2 * M_PI) << psi;
  }
}

TEST(ImcReadings, WhatIsNoNumberIsNotRead) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kEndless = std::numeric_limits<float>::infinity();
  for (const float bad : {kNan, kEndless, -kEndless}) {
    Readings readings;
    give(someState(), 1.7e9, readings);
    give(Temperature{.value = 12}, 1.7e9, readings);
    const Readings before = readings;
    EstimatedState state = someState();
    state.lat = state.x = state.phi = state.theta = state.psi = state.u = state.vz = state.depth =
        state.alt = bad;
    give(state, 1.7e9, readings);
    give(Temperature{.value = bad}, 1.7e9, readings);
    for (uint32_t i = 0; i < kReadings; ++i) {
      const double was = before.value(static_cast<Reading>(i));
      const double is = readings.value(static_cast<Reading>(i));
      EXPECT_TRUE(was == is || (std::isnan(was) && std::isnan(is))) << i;
    }
    EXPECT_EQ(readings.latitude(), before.latitude());
  }
}

TEST(ImcReadings, AFixWithoutAPositionIsIgnored) {
  Readings readings;
  GpsFix fix;
  fix.lat = 41.5 * kDegree;
  fix.lon = -8.25 * kDegree;
  for (const int validity : {0, 1, 2, 3, 0xFFFF - GpsValidity::Position}) {
    fix.validity = static_cast<uint16_t>(validity);
    give(fix, 1.7e9, readings);
    EXPECT_TRUE(std::isnan(readings.value(Reading::FixLatitude))) << validity;
  }
  fix.validity = GpsValidity::Position;
  fix.lat = 1.6;
  give(fix, 1.7e9, readings);
  EXPECT_TRUE(std::isnan(readings.value(Reading::FixLatitude))) << "beyond the pole";
  fix.lat = 41.5 * kDegree;
  give(fix, 1.7e9, readings);
  EXPECT_NEAR(readings.value(Reading::FixLatitude), 4130, 1e-6);
  EXPECT_NEAR(readings.value(Reading::FixLongitude), -815, 1e-6);
  EXPECT_TRUE(std::isnan(readings.value(Reading::Latitude))) << "that is of the state";
}

TEST(ImcReadings, TheOffsetOfAStateCounts) {
  Readings readings;
  EstimatedState state = someState();
  state.x = 1500;
  state.y = -800;
  give(state, 1.7e9, readings);
  EXPECT_NEAR(readings.latitude(), 41.18 + 1500 / 111056.0, 1e-5);
  EXPECT_NEAR(readings.longitude(), -8.71 - 800 / 83940.0, 1e-5);
}

/// Along the meridian and the parallel half way.
TEST(ImcPosition, ADisplacementIsAsLongAsItShouldBe) {
  const auto& earth = GeographicLib::Ellipsoid::WGS84();
  for (double latitude = -69; latitude < 70; latitude += 3) {
    for (const double north_m : {-20000.0, -5000.0, -10.0, 0.0, 300.0, 20000.0}) {
      for (const double east_m : {-20000.0, -1000.0, 0.0, 7.0, 20000.0}) {
        const Place to = displaced({latitude, 10}, north_m, east_m);
        const double middle = (latitude + to.latitude) / 2;
        EXPECT_NEAR(earth.MeridianDistance(to.latitude) - earth.MeridianDistance(latitude), north_m,
                    0.1)
            << latitude << " " << north_m;
        EXPECT_NEAR((to.longitude - 10) * kDegree * earth.CircleRadius(middle), east_m, 0.3)
            << latitude << " " << east_m;
      }
    }
  }
}

TEST(ImcPosition, DegreesAndMinutes) {
  for (const auto& [degrees, ddmm] : {std::pair{0.0, 0.0},
                                      {41.5, 4130.0},
                                      {-8.25, -815.0},
                                      {-0.5, -30.0},
                                      {90.0, 9000.0},
                                      {-179.75, -17945.0},
                                      {59.999999, 5959.99994},
                                      {60.0, 6000.0}}) {
    EXPECT_NEAR(ddmmOf(degrees), ddmm, 1e-9) << degrees;
  }
  EXPECT_TRUE(std::isnan(ddmmOf(std::nan(""))));
}

}  // namespace
}  // namespace glider::runtime::imc
