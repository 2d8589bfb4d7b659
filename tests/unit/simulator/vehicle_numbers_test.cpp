// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/simulator/slocum_vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

/// The vehicle compared with a second one, which was written from the published formulas and shares
/// no code with it, and with numbers computed by hand.
namespace glider::simulator {
namespace {

constexpr double kHalfCircle = std::numbers::pi;

/// The steady glide by bisection on Merckelbach's force balance, in the vertical plane.
struct Glide {
  double ahead = 0, up = 0;
};

Glide balance(double pitch, double force, double density) {
  const double theta = std::fabs(pitch);
  const double cd0 = 0.15, cd1 = 10.4926354534, lift = 3.8 + 3.7342698373;
  const auto excess = [&](double a) { return cd0 + cd1 * a * a - lift * a * std::tan(theta + a); };
  const bool with_the_force = (force > 0) == (pitch > 0);
  if (theta < 11 * kHalfCircle / 180 || !with_the_force) {
    const double speed = std::sqrt(2 * std::fabs(force) / (density * 1.5 * 0.22 * 1.1));
    return {0, force > 0 ? speed : -speed};
  }
  // The smallest root: excess is positive at 0 and falls.
  double low = 0, high = 0;
  while (excess(high) > 0) {
    high += 1e-4;
  }
  low = high - 1e-4;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (excess(middle) > 0 ? low : high) = middle;
  }
  const double path = theta + low;
  const double drag = cd0 + cd1 * low * low;
  const double speed = std::sqrt(2 * std::fabs(force) * std::sin(path) / (density * 0.1 * drag));
  return {speed * std::cos(path), pitch > 0 ? speed * std::sin(path) : -speed * std::sin(path)};
}

/// The second vehicle; dt 0.25 s.
struct Second {
  double pump = 233, pump_to = 233, battery = 0, battery_to = 0, fin = 0, fin_to = 0;
  double pitch = 0, heading = 0, turning = 0, ahead = 0, up = 0, x = 0, y = 0, depth = 0;
  double used_j = 0, coulombs = 0, load_W = 0, resting_V = 14.4;
  bool dived = false;
  double floats_s = 0;

  static void move(double& at, double to, double most) {
    at = to > at ? std::min(to, at + most) : std::max(to, at - most);
  }

  void step(const Ocean& ocean, double now) {
    const double dt = 0.25;
    const double pump_before = pump, battery_before = battery, fin_before = fin;
    move(pump, std::min(std::max(pump_to, -233.0), 233.0), 37.5 * dt);
    move(battery, std::min(std::max(battery_to, -1.425), 1.425), 0.15 * dt);
    move(fin, std::min(std::max(fin_to, -0.45), 0.45), 0.098 * dt);
    const double trim = std::atan(1235 * pump / 1e6 - 28.8 * battery * 0.0254 + 0.14);
    pitch = trim - (trim - pitch) * std::exp(-dt / 3);
    const double volume = 65.0 / 1025 * (1 - 5e-10 * depth * 1e4) + pump / 1e6;
    const double bar = depth / 10;
    const double density = 1025 / (1 - bar / (22695.1 + 3.37534 * bar));  // UNESCO 1983
    const double force = 9.81 * (density * volume - 65);
    // Heavy on the bottom, it is held there by friction.
    const bool lies = depth > 0 && depth >= ocean.waterDepth(x, y) && force < 0;
    Glide glide;
    if (!lies && (depth > 0 || force < 0)) {
      glide = balance(pitch, force, density);
    }
    ahead = glide.ahead - (glide.ahead - ahead) * std::exp(-dt / 8);
    up = glide.up - (glide.up - up) * std::exp(-dt / 8);
    const double wanted = 0.5 * std::sin(fin) * (ahead * ahead + up * up);
    turning = wanted - (wanted - turning) * std::exp(-dt / 15);
    heading = std::fmod(heading + turning * dt + 4 * kHalfCircle, 2 * kHalfCircle);
    const Planar drift = lies ? Planar{} : ocean.current(depth, x, y);
    x += dt * (drift.east + ahead * std::sin(heading));
    y += dt * (drift.north + ahead * std::cos(heading));
    depth -= dt * (up + (lies ? 0 : ocean.verticalCurrent(depth, x, y, now)));
    const double bottom = ocean.waterDepth(x, y);
    if (depth <= 0) {
      depth = 0;
      up = std::min(up, 0.0);
    } else if (depth >= bottom) {
      depth = bottom;
      up = std::max(up, 0.0);
    }
    feed(pump - pump_before, battery != battery_before, fin != fin_before, dt);
  }

  /// Hotel and CTD, what is on at the surface, a surfacing, and the motors.
  void feed(double out, bool battery_moved, bool fin_moved, double dt) {
    double joules = 0.93 * dt + (out > 0 ? (0.29 + 0.018 * depth) * out : 0.40 * -out);
    joules += (battery_moved ? 7.0 : 0) * dt + (fin_moved ? 0.3 : 0) * dt;
    if (depth < 0.5) {
      joules += 4.1 * dt;
      floats_s += dt;
    } else {
      floats_s = 0;
    }
    if (dived && floats_s >= 60) {
      joules += 389;
      dived = false;
    }
    dived = dived || depth > 3;
    used_j += joules;
    resting_V = 14.4 - (14.4 - 10.0) * used_j / 8e6;
    coulombs += joules / resting_V;
    load_W = joules / dt - (joules / dt - load_W) * std::exp(-dt / 30);
  }
};

OceanSettings water(double depth) {
  OceanSettings settings;
  settings.density = 1025;
  settings.bottom.depth_m = depth;
  return settings;
}

void expectSame(const Vehicle& one, const Second& two, double now) {
  ASSERT_NEAR(one.pumpedCc(), two.pump, 1e-9) << now;
  const double volts = two.resting_V - 0.47 * two.load_W / two.resting_V;
  ASSERT_NEAR(one.battery().voltage(), volts, 1e-9) << now;
  ASSERT_NEAR(one.battery().usedJ(), two.used_j, 1e-6) << now;
  ASSERT_NEAR(one.battery().ampHours(), two.coulombs / 3600, 1e-9) << now;
  ASSERT_NEAR(one.batteryPositionIn(), two.battery, 1e-12) << now;
  ASSERT_NEAR(one.fin(), two.fin, 1e-12) << now;
  ASSERT_NEAR(one.pitch(), two.pitch, 1e-12) << now;
  ASSERT_NEAR(one.heading(), two.heading, 1e-9) << now;
  ASSERT_NEAR(one.depth(), two.depth, 1e-7) << now;
  ASSERT_NEAR(one.x(), two.x, 1e-6) << now;
  ASSERT_NEAR(one.y(), two.y, 1e-6) << now;
}

/// Dives, climbs, turns to both sides, floats, meets the bottom: what each leg commands.
struct Leg {
  double seconds, pump, battery, fin;
};

void flyBoth(const OceanSettings& settings, std::initializer_list<Leg> legs) {
  const Ocean ocean(settings);
  Vehicle one = slocumVehicle();
  Second two;
  double now = 0;
  for (const Leg& leg : legs) {
    one.commandPump(two.pump_to = leg.pump);
    one.commandBatteryPosition(two.battery_to = leg.battery);
    one.commandFin(two.fin_to = leg.fin);
    for (const double end = now + leg.seconds; now < end; now += 0.25) {
      one.step(ocean, now);
      two.step(ocean, now);
      ASSERT_NO_FATAL_FAILURE(expectSame(one, two, now));
    }
  }
}

TEST(VehicleNumbers, FliesAsTheSecondVehicle) {
  flyBoth(water(200), {{30, 233, 0, 0},         // floats
                       {200, -233, 0.47, 0.1},  // dives to starboard
                       {90, -100, 0.3, -0.45},  // dives on to port
                       {60, 0, 0, 0},           // levels off: stalled
                       {500, 1000, -3, -1},     // climbs steeply, stops of all motors
                       {100, 233, 0, 0},        // surfaces and floats
                       {200, -1000, 3, 1}});    // dives steeply
}

TEST(VehicleNumbers, MeetsTheBottomAndLeavesIt) {
  flyBoth(water(15), {{300, -233, 0.47, 0}, {400, 233, -0.4, 0}});
  OceanSettings slope = water(15);
  slope.bottom.slope = 0.02;
  slope.bottom.slope_bearing_rad = 0.5;
  slope.current = slope.bottom_current = {0.05, 0.2};
  flyBoth(slope, {{400, -233, 0.47, 0.1}, {400, 233, -0.4, 0}});
}

/// The smallest angle that balances the forces, by looking at every one.
double scannedAttack(double pitch) {
  const FlightCoefficients c = slocumSettings().flight;
  const double lift = c.hull_lift + c.wing_lift;
  const auto excess = [&](double a) {
    return c.drag + c.induced_drag * a * a - lift * a * std::tan(pitch + a);
  };
  for (double a = 0; pitch + a < 1.57; a += 1e-5) {
    if (excess(a) <= 0) {
      return a;
    }
  }
  return std::nan("");
}

TEST(FlightModelNumbers, AttackIsTheSmallestRootOrNone) {
  const FlightCoefficients c = slocumSettings().flight;
  for (double pitch = 0.02; pitch < 1.5; pitch += 0.01) {
    const double scanned = scannedAttack(pitch), found = angleOfAttack(c, pitch);
    if (pitch > 0.12 && pitch < 0.17) {
      continue;  // where the roots meet Newton's steps may miss them: all of it is a stall
    }
    if (pitch <= 0.12) {
      EXPECT_TRUE(std::isnan(found) || std::fabs(found - scanned) < 2e-5) << pitch;
    } else {
      EXPECT_NEAR(found, scanned, 2e-5) << pitch;
    }
    if (!std::isnan(found)) {
      EXPECT_EQ(angleOfAttack(c, -pitch), -found) << pitch;
    }
  }
}

TEST(FlightModelNumbers, AStallMovesBroadside) {
  // 2 N on 1.5 m by 0.22 m with a drag of 1.1 in 1025 kg/m3.
  const FlightCoefficients c = slocumSettings().flight;
  const double speed = std::sqrt(2 * 2 / (1025 * 1.5 * 0.22 * 1.1));
  const SteadyFlight up = steadyFlight(c, 0.1, 2, 1025), down = steadyFlight(c, 0.1, -2, 1025);
  EXPECT_NEAR(up.vertical, speed, 1e-12);
  EXPECT_NEAR(down.vertical, -speed, 1e-12);
  EXPECT_NEAR(up.speed, speed, 1e-12);
  EXPECT_EQ(up.horizontal, 0);
}

TEST(VehicleNumbers, DriftsWithCurrentsAndWaves) {
  OceanSettings settings = water(60);
  settings.current = {0.2, -0.1};
  settings.bottom_current = {-0.05, 0.3};
  settings.thermocline_depth_m = 15;
  settings.wave = {.amplitude_m = 5, .period_s = 600, .wavelength_m = 500};
  flyBoth(settings, {{50, 233, 0, 0}, {250, -233, 0.47, 0.05}, {400, 233, -0.3, 0}});
}

TEST(VehicleNumbers, TrimFollowsThePublishedFit) {
  // tan pitch = 1235 V - 28.8 x + 0.14 with V in m3 and x in m, approached with a lag of 3 s.
  Vehicle vehicle = slocumVehicle();
  const Ocean ocean(water(500));
  vehicle.step(ocean, 0);
  EXPECT_NEAR(vehicle.pitch(), 0.40410 * (1 - std::exp(-0.25 / 3)), 1e-5);
  vehicle.commandPump(100);
  vehicle.commandBatteryPosition(-0.5);
  for (double t = 0.25; t < 60; t += 0.25) {
    vehicle.step(ocean, t);
  }
  EXPECT_NEAR(std::tan(vehicle.pitch()), 0.1235 + 0.36576 + 0.14, 1e-6);
}

TEST(VehicleNumbers, MotorsMoveAtTheirRates) {
  Vehicle vehicle = slocumVehicle();
  const Ocean ocean(water(500));
  vehicle.commandPump(-1000);
  vehicle.commandBatteryPosition(-9);
  vehicle.commandFin(-9);
  for (int i = 0; i < 4; ++i) {
    vehicle.step(ocean, i * 0.25);
  }
  EXPECT_NEAR(vehicle.pumpedCc(), 233 - 37.5, 1e-9);
  EXPECT_NEAR(vehicle.batteryPositionIn(), -0.15, 1e-12);
  EXPECT_NEAR(vehicle.fin(), -0.098, 1e-12);
  for (int i = 0; i < 100; ++i) {
    vehicle.step(ocean, 1 + i * 0.25);
  }
  EXPECT_EQ(vehicle.pumpedCc(), -233);
  EXPECT_EQ(vehicle.batteryPositionIn(), -1.425);
  EXPECT_EQ(vehicle.fin(), -0.45);
}

TEST(VehicleNumbers, TheHullShrinksALittleMoreThanTheWater) {
  // At 100 m the hull of 65/1025 m3 is 5e-10 * 1e6 of itself smaller: 0.3188 N heavier.
  const FlightCoefficients c = slocumSettings().flight;
  EXPECT_NEAR(netBuoyancy(c, 1025, 0, 0) - netBuoyancy(c, 1025, 1e6, 0), 9.81 * 65 * 5e-4, 1e-9);
  const auto rateAt = [](double depth) {
    Vehicle vehicle = slocumVehicle();
    const Ocean ocean(water(1000));
    vehicle.commandPump(-233);
    vehicle.commandBatteryPosition(0.47);
    double now = 0;
    while (vehicle.depth() < depth) {
      vehicle.step(ocean, now += 0.25);
    }
    const double before = vehicle.depth();
    vehicle.step(ocean, now);
    return (vehicle.depth() - before) / 0.25;
  };
  // Speeds go with the root of the force over the density. Sea water is compressed by 4.4e-10 / Pa,
  // so a hull of 5e-10 gains little weight, and one of 4.4e-10 none.
  const auto force = [](double depth_m) {
    const double density = 1025 * compression(depth_m * 1e4);
    const double volume = 65.0 / 1025 * (1 - 5e-10 * depth_m * 1e4) - 233e-6;
    return 9.81 * (65 - density * volume) / density;
  };
  EXPECT_NEAR(rateAt(800) / rateAt(10), std::sqrt(force(800) / force(10)), 2e-3);
  EXPECT_GT(rateAt(800) / rateAt(10), 1.03);
  EXPECT_LT(rateAt(800) / rateAt(10), 1.1);
  // At 1000 m the vehicle has lost the lift of some 40 cc, well within the 233 cc of its pump.
  const double lost = netBuoyancy(c, 1025, 0, 0) - netBuoyancy(c, 1025 * compression(1e7), 1e7, 0);
  EXPECT_NEAR(lost / (9.81 * 1025e-6), 40, 3);
}

TEST(VehicleNumbers, RisingWaterLiftsTheVehicle) {
  // Where the wave begins, the thermocline at 15 m sinks by 5 m * 2 pi / 600 s.
  OceanSettings wave = water(60);
  wave.thermocline_depth_m = 15;
  wave.wave = {.amplitude_m = 5, .period_s = 600};
  const Ocean still(water(60)), sinking(wave);
  Vehicle one = slocumVehicle(), two = slocumVehicle();
  for (Vehicle* vehicle : {&one, &two}) {
    vehicle->commandPump(-233);
    vehicle->commandBatteryPosition(0.47);
    for (double now = 0; vehicle->depth() < 15; now += 0.25) {
      vehicle->step(still, now);
    }
  }
  const double depth = one.depth();
  one.step(still, 0);
  two.step(sinking, 0);
  const double share = (60 - depth) / (60 - 15);
  EXPECT_NEAR(two.depth() - one.depth(), 0.25 * share * 5 * 2 * kHalfCircle / 600, 1e-6);
}

TEST(VehicleNumbers, FloatsAtZeroAndDivesFromThere) {
  Vehicle vehicle = slocumVehicle();
  const Ocean ocean(water(100));
  double now = 0;
  const auto fly = [&](double seconds) {
    for (const double end = now + seconds; now < end; now += 0.25) {
      vehicle.step(ocean, now);
      ASSERT_GE(vehicle.depth(), 0);
    }
  };
  vehicle.commandPump(-233);
  vehicle.commandBatteryPosition(0.47);
  fly(60);
  ASSERT_GT(vehicle.depth(), 3);
  vehicle.commandPump(233);
  vehicle.commandBatteryPosition(-0.4);
  fly(300);
  EXPECT_EQ(vehicle.depth(), 0);
  vehicle.commandPump(-233);
  // The pump needs 6.2 s to be neutral; the way up that it came with is gone, so it sinks at once.
  fly(6);
  EXPECT_EQ(vehicle.depth(), 0);
  fly(3);
  EXPECT_GT(vehicle.depth(), 0);
}

TEST(VehicleNumbers, TurnsByThePublishedFit) {
  // tau dr/dt = 0.5 sin(fin) U^2 - r: after many lags of 15 s the rate is 0.5 sin(fin) U^2.
  for (const double fin : {0.3, -0.3}) {
    Vehicle vehicle = slocumVehicle();
    const Ocean ocean(water(2000));
    vehicle.commandPump(-233);
    vehicle.commandBatteryPosition(0.47);
    vehicle.commandFin(fin);
    double now = 0;
    for (; now < 200; now += 0.25) {
      vehicle.step(ocean, now);
    }
    const double x = vehicle.x(), y = vehicle.y(), z = vehicle.depth(), heading = vehicle.heading();
    vehicle.step(ocean, now);
    const double speed =
        std::hypot(vehicle.x() - x, vehicle.y() - y, vehicle.depth() - z) / Vehicle::kStep;
    const double rate =
        std::remainder(vehicle.heading() - heading, 2 * kHalfCircle) / Vehicle::kStep;
    EXPECT_NEAR(rate, 0.5 * std::sin(fin) * speed * speed, 1e-4) << "of 0.02";
    EXPECT_GE(vehicle.heading(), 0);
    EXPECT_LT(vehicle.heading(), 2 * kHalfCircle);
  }
}

}  // namespace
}  // namespace glider::simulator
