// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/geography/ddmm.h"
#include "simulator/slocum/flight/navigator.h"
#include "tests/unit/simulator/slocum_vehicle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

OceanSettings still() {
  OceanSettings settings;
  settings.density = 1025;
  settings.bottom.depth_m = 100;
  return settings;
}

void fly(Vehicle& vehicle, const Ocean& ocean, double seconds) {
  for (double t = 0; t < seconds; t += Vehicle::kStep) {
    vehicle.step(ocean, t);
  }
}

TEST(Vehicle, FloatsPumpedOut) {
  Vehicle vehicle = slocumVehicle();
  const Ocean ocean(still());
  fly(vehicle, ocean, 100);
  EXPECT_EQ(vehicle.depth(), 0);
  EXPECT_EQ(vehicle.x(), 0);
}

TEST(Vehicle, PumpMovesAtItsRateBetweenItsStops) {
  Vehicle vehicle = slocumVehicle();
  const Ocean ocean(still());
  vehicle.commandPump(-1000);
  fly(vehicle, ocean, 4);
  EXPECT_NEAR(vehicle.pumpedCc(), 233 - 4 * 37.5, 1e-9);
  fly(vehicle, ocean, 20);
  EXPECT_EQ(vehicle.pumpedCc(), -233);
}

TEST(Vehicle, DivesAtTheModelsSpeedAndStopsAtTheBottom) {
  VehicleSettings eastward = slocumSettings();
  eastward.initial_heading_rad = std::numbers::pi / 2;
  Vehicle vehicle = slocumVehicle(eastward);
  const Ocean ocean(still());
  vehicle.commandPump(-233);
  vehicle.commandBatteryPosition(0.47);
  fly(vehicle, ocean, 120);
  const double before = vehicle.depth();
  fly(vehicle, ocean, 40);
  const double rate = (vehicle.depth() - before) / 40;
  EXPECT_NEAR(vehicle.pitch(), -26 * std::numbers::pi / 180, 0.02);
  EXPECT_GT(rate, 0.15);
  EXPECT_LT(rate, 0.20);
  EXPECT_GT(vehicle.x(), 20) << "heading east";
  EXPECT_NEAR(vehicle.y(), 0, 1e-9);
  fly(vehicle, ocean, 2000);
  EXPECT_EQ(vehicle.depth(), 100);
}

TEST(Vehicle, TurnsWithItsFinAndDriftsWithTheCurrent) {
  OceanSettings settings = still();
  settings.current = settings.bottom_current = {0.1, -0.2};
  const Ocean ocean(settings);
  Vehicle drifting = slocumVehicle();
  fly(drifting, ocean, 100);
  EXPECT_NEAR(drifting.x(), 10, 1e-9);
  EXPECT_NEAR(drifting.y(), -20, 1e-9);
  Vehicle turning = slocumVehicle();
  turning.commandPump(-233);
  turning.commandBatteryPosition(0.47);
  turning.commandFin(0.45);
  fly(turning, ocean, 150);
  EXPECT_GT(turning.heading(), 0.5) << "to starboard";
}

TEST(Battery, FallsInAStraightLineToItsEmptyVoltage) {
  const BatterySettings small{
      .capacity_j = 4000, .full_V = 14, .empty_V = 10, .start_V = 12, .hotel_W = 2, .sbc_W = 3};
  Battery battery(small);
  EXPECT_EQ(battery.voltage(), 12);
  EXPECT_NEAR(battery.ampHours(), 2000 / 13.0 / 3600, 1e-12);
  battery.idle(100, false);
  EXPECT_NEAR(battery.voltage(), 12 - 4 * 200 / 4000.0, 1e-12);
  battery.idle(100, true);
  EXPECT_NEAR(battery.voltage(), 12 - 4 * 700 / 4000.0, 1e-12);
  battery.use(47);
  EXPECT_NEAR(battery.voltage(), 12 - 4 * (700 + 47) / 4000.0, 1e-12);
  battery.idle(1e6, true);
  EXPECT_EQ(battery.voltage(), 10);
}

TEST(Vehicle, FeedsTheSbcFromItsBattery) {
  VehicleSettings settings = slocumSettings();
  settings.battery.capacity_j = 4400;
  settings.battery.sbc_W = 3.37;
  Vehicle vehicle = slocumVehicle(settings);
  const Ocean ocean(still());
  fly(vehicle, ocean, 100);
  EXPECT_NEAR(vehicle.battery().voltage(), 14.4 - 0.163, 1e-9);
  vehicle.feedSbc(true);
  fly(vehicle, ocean, 100);
  EXPECT_NEAR(vehicle.battery().voltage(), 14.4 - 0.163 - 0.5, 1e-9);
}

TEST(Vehicle, DriftsWithTheCurrentOfItsDepth) {
  OceanSettings settings = still();
  settings.current = {0.1, 0};
  settings.bottom_current = {-0.1, 0};
  Vehicle vehicle = slocumVehicle();
  const Ocean ocean(settings);
  vehicle.commandPump(-233);
  vehicle.commandBatteryPosition(0.47);
  fly(vehicle, ocean, 3000);
  ASSERT_EQ(vehicle.depth(), 100);
  double before = vehicle.x();
  fly(vehicle, ocean, 100);
  EXPECT_EQ(vehicle.x(), before) << "lies on the bottom";
  vehicle.commandPump(233);
  vehicle.commandBatteryPosition(-0.4);
  fly(vehicle, ocean, 60);
  ASSERT_GT(vehicle.depth(), 75);
  ASSERT_LT(vehicle.depth(), 100);
  EXPECT_LT(vehicle.x(), before - 1) << "heading north, it drifts west near the bottom";
  fly(vehicle, ocean, 1000);
  ASSERT_EQ(vehicle.depth(), 0);
  before = vehicle.x();
  fly(vehicle, ocean, 100);
  EXPECT_NEAR(vehicle.x() - before, 10, 1e-6) << "and east at the surface";
}

TEST(Navigator, ReckonsFromDepthRateAndPitchUntilAFix) {
  const LocalFrame frame(39, -73);
  Navigator navigator(frame);
  for (int i = 0; i < 100; ++i) {
    navigator.reckon(0.17, -0.454, std::numbers::pi / 2, false, 4);
  }
  EXPECT_NEAR(navigator.speed(), 0.17 / std::tan(0.454), 1e-12);
  EXPECT_NEAR(navigator.eastOfStart(), 400 * navigator.speed(), 1e-9);
  navigator.reckon(0.17, -0.01, 0, false, 4);
  EXPECT_NEAR(navigator.speed(), 0.17 / std::tan(0.454), 1e-12) << "level: the last speed is kept";
  navigator.fix({5, 6});
  EXPECT_EQ(navigator.eastOfStart(), 5);
  const GeoPosition there = frame.position(1005, 6);
  double distance = 0, bearing = 0;
  navigator.toWaypoint(toDdmm(there.latitude_deg), toDdmm(there.longitude_deg), distance, bearing);
  EXPECT_NEAR(distance, 1000, 0.01);
  EXPECT_NEAR(bearing, std::numbers::pi / 2, 1e-6);
}

TEST(Position, WritesDegreesAndMinutes) {
  EXPECT_NEAR(toDdmm(-73.830097), -7349.80582, 1e-8);
  EXPECT_NEAR(fromDdmm(3910.5), 39.175, 1e-12);
  EXPECT_NEAR(fromDdmm(toDdmm(-0.25)), -0.25, 1e-15);
}

}  // namespace
}  // namespace glider::simulator
