// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/simulator/propelled_vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

/// How a vehicle with a propeller behaves: motors, energy, surface, bottom, currents, extremes.
namespace glider::simulator {
namespace {

/// The pitch at which the vehicle's own computer goes to a depth: DUNE's 15 degrees, and 25 of a
/// REMUS.
double steepestOf(const platforms::Platform& platform) {
  return platform.name == "lauv" ? 0.2618 : 0.4363;
}

class Propelled : public ::testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] PropelledFlight flight(double depth_m = 20, double water_m = 500) const {
    return {GetParam(), buoyancyOf(GetParam()), propelledWater(water_m), depth_m};
  }
};
INSTANTIATE_TEST_SUITE_P(Vehicles, Propelled, ::testing::Values("lauv", "remus100"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(Propelled, FloatsUpWhenItStopsAndStaysAtTheSurface) {
  PropelledFlight one = flight();
  one.command.rpm = 1000;
  one.fly(60);
  EXPECT_GT(one.state.ahead_mps, 1);
  one.command.rpm = 0;
  one.state.depth_m = 30;
  one.fly(60);
  EXPECT_LT(one.state.ahead_mps, 0.05) << "it has lost its way";
  EXPECT_GT(one.state.up_mps, 0.06);
  one.fly(1000);
  const double floats = one.state.depth_m;
  const double radius = propelledPlatform(GetParam()).motion->propelled->hull.diameter_m / 2;
  EXPECT_GT(radius - floats, 0) << "some freeboard";
  EXPECT_LT(radius - floats, 0.02) << "but little";
  one.fly(100);
  EXPECT_NEAR(one.state.depth_m, floats, 1e-4) << "and it stays";
  PropelledFlight other(GetParam(), buoyancyOf(GetParam()), propelledWater(500), 0);
  other.fly(200);
  EXPECT_NEAR(other.state.depth_m, floats, 1e-3) << "half out of the water it sinks to there";
}

TEST(PropelledLauv, RisesAsWasMeasured) {
  PropelledFlight lauv("lauv", buoyancyOf("lauv"), propelledWater(500), 40);
  lauv.fly(60);
  EXPECT_NEAR(lauv.state.up_mps, 0.07, 0.005);
  EXPECT_NEAR(lauv.state.pitch_rad, 0, 0.05) << "level";
}

/// DUNE's speeds by rpm.
TEST(PropelledLauv, HasItsSpeedsByRpm) {
  for (const auto& [rpm, speed] : {std::pair{900.0, 1.0}, {1067.0, 1.2}, {1150.0, 1.3}}) {
    PropelledFlight lauv("lauv", 0, propelledWater(500), 20);
    lauv.command.rpm = rpm;
    lauv.fly(200);
    EXPECT_NEAR(lauv.state.ahead_mps, speed, 0.01) << rpm;
  }
}

TEST_P(Propelled, TurnsTheSameToBothSides) {
  PropelledFlight one = flight(), two = flight();
  one.command = two.command = {.rpm = 1000, .stern_plane_rad = -0.05};
  one.command.fin_rad = 0.2;
  two.command.fin_rad = -0.2;
  one.fly(1);
  EXPECT_GT(one.state.fin.position, 0);
  one.fly(59);
  two.fly(60);
  EXPECT_GT(one.state.x_m, 1) << "to starboard first";
  EXPECT_NEAR(one.state.x_m, -two.state.x_m, 1e-9);
  EXPECT_NEAR(one.state.y_m, two.state.y_m, 1e-9);
  EXPECT_NEAR(one.state.depth_m, two.state.depth_m, 1e-9);
  EXPECT_NEAR(one.state.turn_rate_rad_s, -two.state.turn_rate_rad_s, 1e-9);
  EXPECT_GT(one.state.turn_rate_rad_s, 0.02) << "positive turns to starboard";
}

TEST_P(Propelled, ThePlanesRaiseAndLowerTheNose) {
  PropelledFlight up = flight(100), down = flight(100);
  up.command = {.rpm = 900, .stern_plane_rad = 0.05};
  down.command = {.rpm = 900, .stern_plane_rad = -0.05};
  up.fly(20);
  down.fly(20);
  EXPECT_GT(up.state.pitch_rad, down.state.pitch_rad + 0.1);
  EXPECT_LT(up.state.depth_m, down.state.depth_m - 1);
}

TEST_P(Propelled, IsCarriedByTheWater) {
  OceanSettings moving = propelledWater(500);
  moving.current = moving.bottom_current = {0.3, -0.2};
  PropelledFlight still = flight(), carried(GetParam(), buoyancyOf(GetParam()), moving, 20);
  still.command = carried.command = {.fin_rad = 0.03, .rpm = 900};
  still.fly(100);
  carried.fly(100);
  EXPECT_NEAR(carried.state.x_m - still.state.x_m, 30, 1e-6);
  EXPECT_NEAR(carried.state.y_m - still.state.y_m, -20, 1e-6);
  EXPECT_EQ(carried.state.ahead_mps, still.state.ahead_mps) << "through the water";
  EXPECT_EQ(carried.state.heading_rad, still.state.heading_rad);
}

TEST_P(Propelled, IsLiftedByRisingWater) {
  OceanSettings waves = propelledWater(60);
  waves.thermocline_depth_m = 15;
  waves.wave = {.amplitude_m = 5, .period_s = 600};
  PropelledFlight still = flight(15, 60), moved(GetParam(), buoyancyOf(GetParam()), waves, 15);
  still.fly(0.25);
  moved.fly(0.25);
  EXPECT_NEAR(moved.state.depth_m - still.state.depth_m, 0.25 * 5 * 2 * std::numbers::pi / 600,
              1e-3);
  EXPECT_GT(moved.state.depth_m, still.state.depth_m + 0.01);
}

TEST_P(Propelled, DoesNotGoThroughTheBottom) {
  PropelledFlight one = flight(5, 20);
  one.command = {.rpm = 1200, .stern_plane_rad = -0.2};
  double deepest = 0;
  for (int i = 0; i < 400; ++i) {
    one.fly(0.25);
    deepest = std::max(deepest, one.state.depth_m);
  }
  EXPECT_EQ(deepest, 20);
  one.command = {.rpm = 1200, .stern_plane_rad = 0.2};
  one.fly(10);
  EXPECT_LT(one.state.depth_m, 20) << "and comes off it";
}

TEST_P(Propelled, AHeavyOneLiesOnTheBottom) {
  OceanSettings moving = propelledWater(20);
  moving.current = moving.bottom_current = {0.3, -0.2};
  PropelledFlight one(GetParam(), -0.5, moving, 15);
  one.command.rpm = 900;
  one.fly(5);
  one.command.rpm = 0;
  one.fly(200);
  const double x = one.state.x_m, y = one.state.y_m;
  EXPECT_EQ(one.state.depth_m, 20);
  one.fly(100);
  EXPECT_NEAR(one.state.x_m, x, 1e-3);
  EXPECT_NEAR(one.state.y_m, y, 1e-3);
}

TEST_P(Propelled, ItLosesItsWayOnTheBottom) {
  PropelledFlight one(GetParam(), -1, propelledWater(20), 19);
  one.command.rpm = 1000;
  while (one.state.depth_m < 20) {
    one.fly(0.25);
  }
  ASSERT_GT(one.state.ahead_mps, 0.2);
  one.command.rpm = 0;
  one.fly(20);
  EXPECT_LT(one.state.ahead_mps, 0.01);
}

TEST_P(Propelled, ItsMotorsLagAndStop) {
  const auto& motion = *propelledPlatform(GetParam()).motion->propelled;
  PropelledFlight one = flight();
  one.command = {.fin_rad = 9, .rpm = 1e6, .stern_plane_rad = -9};
  one.fly(0.25);
  EXPECT_GT(one.state.rpm.position, 0);
  EXPECT_LE(one.state.rpm.position, motion.propeller.rpm_rate_rpm_s * 0.25 + 1e-9);
  EXPECT_LE(one.state.fin.position, motion.fins.rate_rad_s * 0.25);
  one.fly(60);
  EXPECT_NEAR(one.state.rpm.position, motion.propeller.greatest_rpm, 0.1);
  EXPECT_NEAR(one.state.fin.position, motion.fins.rudder_rad, 1e-9);
  EXPECT_NEAR(one.state.stern_plane.position, -motion.fins.stern_plane_rad, 1e-9);
  one.command.rpm = -500;
  one.fly(60);
  EXPECT_NEAR(one.state.rpm.position, 0, 0.1) << "it does not turn astern";
}

/// 1 - 1/e of a small change after one lag.
TEST(PropelledMotors, FollowALag) {
  RateLimited motor{
      .position = 0, .target = 1, .rate = 100, .lowest = -2, .highest = 2, .lag_s = 0.5};
  for (int i = 0; i < 20; ++i) {
    motor.step(0.025);
  }
  EXPECT_NEAR(motor.position, 1 - std::exp(-1), 1e-12);
}

TEST_P(Propelled, UsesTheEnergyOfItsPowerTable) {
  const platforms::Platform& platform = propelledPlatform(GetParam());
  Vehicle vehicle(platform, settingsOf(platform));
  const Ocean ocean(OceanSettings{});
  const auto fly = [&](double seconds) {
    for (double now = 0; now < seconds; now += Vehicle::kStep) {
      vehicle.step(ocean, now);
    }
  };
  vehicle.commandPropeller(700);
  fly(60);
  const double before = vehicle.battery().usedJ();
  fly(600);
  EXPECT_NEAR(vehicle.battery().usedJ() - before,
              600 * (platform.power.draws.at(0).amount + powerAt(platform.power.propeller, 700)),
              0.1);
}

TEST(PropelledPower, IsStraightBetweenThePointsOfItsTable) {
  const platforms::PropellerPower& table = propelledPlatform("lauv").power.propeller;
  const std::pair<double, double> points[] = {{0, 0},     {250, 15},  {500, 30},  {750, 40},
                                              {1000, 50}, {1350, 65}, {1700, 80}, {2500, 80}};
  for (const auto& [rpm, watt] : points) {
    EXPECT_NEAR(powerAt(table, rpm), watt, 1e-12) << rpm;
  }
  EXPECT_EQ(powerAt(table, -3), 0);
}

TEST_P(Propelled, AnEmptyBatteryLetsItFloatUp) {
  const platforms::Platform& platform = propelledPlatform(GetParam());
  VehicleSettings settings = settingsOf(platform);
  settings.flight.hull_volume_m3 = settings.flight.mass_kg / propelledWater(100).density;
  Vehicle vehicle(platform, settings);
  const Ocean ocean(propelledWater(100));
  const auto fly = [&](double seconds) {
    for (double now = 0; now < seconds; now += Vehicle::kStep) {
      vehicle.step(ocean, now);
    }
  };
  vehicle.commandPropeller(1000);
  vehicle.commandSternPlane(-0.2);
  fly(60);
  vehicle.commandSternPlane(0);
  vehicle.useByModem(1e9);
  ASSERT_GT(vehicle.depth(), 3);
  const double deep = vehicle.depth();
  fly(120);
  EXPECT_NEAR(vehicle.rpm(), 0, 0.5);
  EXPECT_LT(vehicle.depth(), deep);
}

TEST_P(Propelled, StaysSaneAtExtremes) {
  std::mt19937_64 random(7);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  OceanSettings rough = propelledWater(30);
  rough.thermocline_depth_m = 10;
  rough.density_step = 8;
  rough.wave = {.amplitude_m = 5, .period_s = 300, .wavelength_m = 300};
  PropelledFlight one(GetParam(), buoyancyOf(GetParam()), rough, 10);
  const double far = 1e12;
  for (int i = 0; i < 2000; ++i) {
    one.command = {.fin_rad = i % 3 == 0 ? within(-far, far) : within(-0.3, 0.3),
                   .rpm = i % 5 == 0 ? far : within(-500, 2000),
                   .stern_plane_rad = i % 4 == 0 ? within(-far, far) : within(-0.3, 0.3)};
    one.fly(within(0.25, 20));
    const VehicleState& s = one.state;
    for (const double number : {s.x_m, s.y_m, s.depth_m, s.pitch_rad, s.heading_rad, s.ahead_mps,
                                s.up_mps, s.turn_rate_rad_s}) {
      ASSERT_TRUE(std::isfinite(number)) << i;
    }
    ASSERT_GE(s.depth_m, 0);
    ASSERT_LE(s.depth_m, 30);
    ASSERT_LE(std::fabs(s.pitch_rad), 80.001 * kDegree);
    ASSERT_LT(std::hypot(s.ahead_mps, s.up_mps), 3.5);
    ASSERT_GE(s.heading_rad, 0);
    ASSERT_LT(s.heading_rad, 2 * std::numbers::pi);
  }
}

/// The environment model of its platform: after a dive that a command or a stopped motor ends, it
/// goes no further and climbs no later than proofs assume, and at full speed no faster.
TEST_P(Propelled, StaysWithinWhatProofsAssume) {
  const platforms::Platform& platform = propelledPlatform(GetParam());
  const double steepest = steepestOf(platform);
  constexpr double kTimeOut = 15;  // s without commands before the motor is stopped
  for (const bool stops : {true, false}) {
    PropelledFlight one = flight();
    one.command.rpm = platform.motion->propelled->propeller.greatest_rpm;
    double fastest = 0, vertical = 0;
    for (int i = 0; i < 4 * 100; ++i) {
      steerToDepth(one, 400, steepest);
      one.fly(0.25);
      fastest = std::max(fastest, one.state.ahead_mps);
      vertical = std::max(vertical, std::fabs(one.state.up_mps));
    }
    EXPECT_LT(fastest, platform.world.through_water_m_s);
    EXPECT_LT(vertical, platform.envelope.vertical_rate_m_s);
    const double began = one.now, from = one.state.depth_m;
    double deepest = from, climbs = 0;
    for (int i = 0; i < 4 * 60; ++i) {
      steerToDepth(one, 5, steepest);
      one.command = stops ? VehicleCommand{} : one.command;
      one.fly(0.25);
      deepest = std::max(deepest, one.state.depth_m);
      climbs = one.state.up_mps < platform.world.slowest_climb_m_s ? one.now - began : climbs;
    }
    EXPECT_LT(deepest - from, platform.envelope.inflection_overshoot_m) << stops;
    EXPECT_LT(climbs, platform.world.turn_s - kTimeOut) << stops;
    EXPECT_GT(one.state.up_mps, platform.world.slowest_climb_m_s) << stops;
  }
  PropelledFlight one = flight();
  one.command.rpm = platform.motion->propelled->propeller.greatest_rpm;
  double deepest = 0;
  for (int i = 0; i < 4 * 200; ++i) {
    steerToDepth(one, 40, steepest);
    one.fly(0.25);
    deepest = std::max(deepest, one.state.depth_m);
  }
  EXPECT_LT(deepest, 40 + platform.envelope.inflection_overshoot_m) << "past a commanded depth";
  EXPECT_GT(deepest, 39.5);
}

/// Hard over at full speed it would loop.
TEST_P(Propelled, DoesNotLoop) {
  for (const double plane : {1.0, -1.0}) {
    PropelledFlight one = flight(250);
    one.command = {.rpm = 2000, .stern_plane_rad = plane};
    double steepest = 0;
    for (int i = 0; i < 200; ++i) {
      one.fly(0.25);
      steepest = std::max(steepest, std::fabs(one.state.pitch_rad));
    }
    EXPECT_LE(steepest, 80.001 * kDegree);
  }
}

}  // namespace
}  // namespace glider::simulator
