// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/scenario/scenario.h"
#include "tests/support/command.h"
#include "tests/unit/simulator/propelled_vehicle.h"

#include <gtest/gtest.h>

#include <string>

/// What a scenario may say of a vehicle with a propeller, and the vehicle that it makes.
namespace glider::simulator {
namespace {

constexpr const char* kHead =
    "name = \"x\"\nskeleton = \"x.mi\"\nduration_s = 600\n"
    "[start]\nlatitude_deg = 41.18\nlongitude_deg = -8.70\n";

/// The scenario with `more` for the LAUV, or why it is refused.
support::Result<Scenario> load(const std::string& more) {
  const tests::TemporaryFolder folder;
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  return loadScenario(folder.write("x.toml", kHead + more), propelledPlatform("lauv"), sources,
                      diagnostics);
}

TEST(PropelledScenario, BallastsTheVehicleForItsWater) {
  const auto scenario = load("[ocean]\ndensity_kgm3 = 1020\n");
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->vehicle.flight.hull_volume_m3, 24.0 / 1020);
  EXPECT_EQ(scenario->vehicle.positive_buoyancy_kg, 0.2);
  EXPECT_EQ(scenario->vehicle.battery.power.capacity_kj, 1890);
  // It is as buoyant there as in denser water.
  for (const char* density : {"1000", "1030"}) {
    const auto here = load(std::string("[ocean]\ndensity_kgm3 = ") + density + "\n");
    ASSERT_TRUE(here);
    Vehicle vehicle(propelledPlatform("lauv"), here->vehicle);
    EXPECT_NEAR(vehicle.depth(), 0.074, 1e-3);
  }
}

// accepts: GL5001
TEST(PropelledScenario, MayChangeTheBuoyancy) {
  const auto heavy = load("[vehicle]\npositive_buoyancy_kg = -0.3\n");
  ASSERT_TRUE(heavy) << heavy.error().message;
  EXPECT_EQ(heavy->vehicle.positive_buoyancy_kg, -0.3);
  EXPECT_FALSE(load("[vehicle]\npositive_buoyancy_kg = 50.0\n"));
}

/// A scenario for gliders serves it too: their numbers change nothing.
TEST(PropelledScenario, HasNoUseForTheNumbersOfAGlider) {
  const auto scenario =
      load("[vehicle]\nmass_kg = 65.0\ndrag = 0.12\nwing_lift = 3.0\nhull_volume_m3 = 0.06\n");
  ASSERT_TRUE(scenario) << scenario.error().message;
  EXPECT_EQ(scenario->vehicle.flight.mass_kg, 24);
  EXPECT_EQ(scenario->vehicle.flight.hull_volume_m3, 24.0 / 1025);
  EXPECT_FALSE(load("[vehicle]\ndrag = -1.0\n")) << "they are checked, too";
}

/// The commands of a seat reach the devices.
TEST(PropelledScenario, TheVehicleObeysItsCommands) {
  const auto scenario = load("[vehicle.battery]\nsbc_W = 4.0\n");
  ASSERT_TRUE(scenario) << scenario.error().message;
  Vehicle vehicle(propelledPlatform("lauv"), scenario->vehicle);
  const Ocean ocean(propelledWater(100));
  EXPECT_EQ(vehicle.limits().rpm, 1700);
  EXPECT_EQ(vehicle.limits().fin_rad, 0.5236);
  EXPECT_EQ(vehicle.limits().stern_plane_rad, 0.5236);
  EXPECT_EQ(vehicle.limits().pump_cc, 0);
  vehicle.commandPropeller(1067);
  vehicle.commandFin(0.1);
  vehicle.commandSternPlane(-0.1);
  vehicle.feedSbc(true);
  vehicle.commandPump(200);  // it has none
  for (double now = 0; now < 30; now += Vehicle::kStep) {
    vehicle.step(ocean, now);
  }
  EXPECT_NEAR(vehicle.rpm(), 1067, 1);
  EXPECT_NEAR(vehicle.fin(), 0.1, 1e-6);
  EXPECT_NEAR(vehicle.sternPlane(), -0.1, 1e-6);
  EXPECT_LT(vehicle.pitch(), -0.1);
  EXPECT_GT(vehicle.depth(), 2);
  EXPECT_GT(vehicle.heading(), 0.5) << "to starboard";
  EXPECT_GT(vehicle.turnRate(), 0.02);
  EXPECT_GT(vehicle.aheadMps(), 0.7);
  EXPECT_LT(vehicle.upMps(), -0.1);
  EXPECT_EQ(vehicle.pumpedCc(), 0);
  const double used = vehicle.battery().usedJ();
  vehicle.step(ocean, 30);
  EXPECT_NEAR(vehicle.battery().usedJ() - used, 0.25 * (15 + 4 + 52.87), 0.05);
}

}  // namespace
}  // namespace glider::simulator
