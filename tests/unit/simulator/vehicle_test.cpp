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

/// A row of a power table.
platforms::Draw row(const char* device, platforms::DrawWhen when, double amount,
                    double amount_per_m = 0, std::vector<std::string> sensors = {}) {
  platforms::Draw draw;
  draw.device = device;
  draw.when = when;
  draw.amount = amount;
  draw.amount_per_m = amount_per_m;
  draw.sensors = std::move(sensors);
  return draw;
}

/// A pack of 4 kJ with a device, the SBC and a modem.
BatterySettings smallPack() {
  BatterySettings small;
  small.power.capacity_kj = 4;
  small.power.full_V = 14;
  small.power.empty_V = 10;
  small.power.draws = {row("hotel", platforms::DrawWhen::Always, 2)};
  small.start_V = 12;
  return small;
}

TEST(Battery, FallsInAStraightLineToItsEmptyVoltage) {
  Battery battery(smallPack());
  EXPECT_EQ(battery.voltage(), 12);
  EXPECT_NEAR(battery.ampHours(), 2000 / 13.0 / 3600, 1e-12);
  battery.use(0, 200);
  battery.use(1, 500);
  battery.settle(100);
  EXPECT_NEAR(battery.voltage(), 12 - 4 * 700 / 4000.0, 1e-12);
  EXPECT_EQ(battery.usedByJ(0), 200);
  EXPECT_EQ(battery.usedByJ(1), 500);
  EXPECT_EQ(battery.usedByJ(2), 0);
  EXPECT_FALSE(battery.empty());
  battery.use(1, 1e6);
  EXPECT_TRUE(battery.empty());
  EXPECT_EQ(battery.voltage(), 10);
  EXPECT_EQ(battery.usedByJ(1), 1800) << "what the pack had";
}

TEST(Battery, SagsUnderTheLoadOfTheLastHalfMinute) {
  BatterySettings settings = smallPack();
  settings.power.capacity_kj = 1e6;
  settings.power.resistance_ohm = 0.5;
  Battery battery(settings);
  const double rest = battery.voltage();
  for (int i = 0; i < 30 * 4; ++i) {
    battery.use(0, 24 * 0.25);  // 24 W: 2 A
    battery.settle(0.25);
  }
  EXPECT_NEAR(rest - battery.voltage(), 1.0 * (1 - std::exp(-1.0)), 0.01);
  for (int i = 0; i < 300 * 4; ++i) {
    battery.settle(0.25);
  }
  EXPECT_NEAR(battery.voltage(), rest, 0.001);
  EXPECT_NEAR(battery.ampHours() - 5e8 / 13 / 3600, 24 * 30 / 12.0 / 3600, 1e-6);
}

TEST(Loads, EachDrawsWhenItsRowSays) {
  using platforms::DrawWhen;
  BatterySettings settings;
  settings.power.capacity_kj = 100;
  settings.power.full_V = 14;
  settings.power.empty_V = 10;
  settings.power.draws = {
      row("hotel", DrawWhen::Always, 2),         row("radio", DrawWhen::Surface, 3),
      row("air pump", DrawWhen::Surfacing, 400), row("optode", DrawWhen::Read, 5, 0, {"oxygen"}),
      row("pump", DrawWhen::PumpOut, 0.5, 0.1),  row("pump", DrawWhen::PumpIn, 0.25),
      row("battery", DrawWhen::PitchBattery, 7), row("fin", DrawWhen::Fin, 11)};
  settings.start_V = 14;
  settings.sbc_W = 13;
  const auto taken = [&](const Doings& doings, bool reads = false) {
    Loads loads(settings);
    const std::vector<std::string> sensors = {"temp", "oxygen"};
    loads.read(std::span(sensors).first(reads ? 2 : 1));
    Battery battery(settings);
    loads.draw(battery, doings);
    return battery.usedJ();
  };
  EXPECT_EQ(taken({.seconds = 10}), 20);
  EXPECT_EQ(taken({.seconds = 10, .at_surface = true}), 20 + 30);
  EXPECT_EQ(taken({.seconds = 10, .surfaces = true}), 20 + 400);
  EXPECT_EQ(taken({.seconds = 10}, true), 20) << "without the SBC nothing reads";
  EXPECT_EQ(taken({.seconds = 10, .sbc_powered = true}), 20 + 130);
  EXPECT_EQ(taken({.seconds = 10, .sbc_powered = true, .sbc_asleep = true}), 20 + 130)
      << "nothing is known of how it sleeps";
  settings.sbc_asleep_W = 4;
  EXPECT_EQ(taken({.seconds = 10, .sbc_powered = true, .sbc_asleep = true}), 20 + 40);
  EXPECT_EQ(taken({.seconds = 10, .sbc_powered = true}), 20 + 130);
  EXPECT_EQ(taken({.seconds = 10, .sbc_asleep = true}), 20);
  EXPECT_EQ(taken({.seconds = 10, .sbc_powered = true}, true), 20 + 130 + 50);
  EXPECT_EQ(taken({.seconds = 10, .depth_m = 40, .pumped_cc = 8}), 20 + 8 * (0.5 + 4));
  EXPECT_EQ(taken({.seconds = 10, .depth_m = 40, .pumped_cc = -8}), 20 + 8 * 0.25);
  EXPECT_EQ(taken({.seconds = 10, .pitch_battery_moves = true}), 20 + 70);
  EXPECT_EQ(taken({.seconds = 10, .fin_moves = true}), 20 + 110);
}

TEST(Vehicle, FeedsTheSbcFromItsBattery) {
  VehicleSettings settings = slocumSettings();
  settings.battery.sbc_W = 3.37;
  Vehicle vehicle = slocumVehicle(settings);
  const Ocean ocean(still());
  fly(vehicle, ocean, 100);
  const double without = vehicle.battery().usedJ();
  vehicle.feedSbc(true);
  fly(vehicle, ocean, 100);
  EXPECT_NEAR(vehicle.battery().usedJ() - without, without + 337, 1e-6);
}

TEST(Vehicle, WithAnEmptyPackNoMotorMoves) {
  VehicleSettings settings = slocumSettings();
  settings.battery.power.capacity_kj = 0.3;
  Vehicle vehicle = slocumVehicle(settings);
  const Ocean ocean(still());
  vehicle.commandPump(-233);
  fly(vehicle, ocean, 100);
  EXPECT_TRUE(vehicle.battery().empty());
  const double stuck = vehicle.pumpedCc();
  vehicle.commandPump(233);
  vehicle.commandFin(0.3);
  vehicle.commandBatteryPosition(0.5);
  fly(vehicle, ocean, 100);
  EXPECT_EQ(vehicle.pumpedCc(), stuck);
  EXPECT_EQ(vehicle.fin(), 0);
  EXPECT_EQ(vehicle.batteryPositionIn(), 0);
}

TEST(Vehicle, PaysForASurfacingOnceItHasDived) {
  VehicleSettings settings = slocumSettings();
  settings.battery.power.draws = {row("air pump", platforms::DrawWhen::Surfacing, 400)};
  Vehicle vehicle = slocumVehicle(settings);
  const Ocean ocean(still());
  fly(vehicle, ocean, 100);
  EXPECT_EQ(vehicle.battery().usedJ(), 0);
  vehicle.commandPump(-233);
  vehicle.commandBatteryPosition(0.47);
  fly(vehicle, ocean, 200);
  ASSERT_GT(vehicle.depth(), 3);
  EXPECT_EQ(vehicle.battery().usedJ(), 0);
  vehicle.commandPump(233);
  vehicle.commandBatteryPosition(-0.4);
  fly(vehicle, ocean, 1000);
  ASSERT_EQ(vehicle.depth(), 0);
  EXPECT_EQ(vehicle.battery().usedJ(), 400);
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
