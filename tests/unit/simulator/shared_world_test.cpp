// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Several vehicles in one world: one clock, one origin, one water, random numbers of their own.

#include "simulator/simulated_vehicle.h"
#include "simulator/simulator.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace glider::simulator {
namespace {

constexpr double kKilometreNorth_deg = 1000 / 111e3;
constexpr double kFlight_s = 800;

SimulationSetup setup(double north_deg = 0) {
  SimulationSetup setup = shippedSetup("shelf_slope");
  setup.scenario.latitude_deg += north_deg;
  setup.duration_s = kFlight_s;
  return setup;
}

std::unique_ptr<SimulatedVehicle> made(SimulationSetup setup, const World& world, uint32_t number) {
  auto vehicle = SimulatedVehicle::make(std::move(setup), world, number);
  EXPECT_TRUE(vehicle.has_value());
  return vehicle ? std::move(*vehicle) : nullptr;
}

/// The traces of vehicles that fly together.
std::vector<support::Trace> flyTogether(World& world,
                                        std::vector<std::unique_ptr<SimulatedVehicle>> vehicles) {
  const auto flying = [&] {
    return std::ranges::any_of(vehicles, [](const auto& v) { return v->flying(); });
  };
  while (flying()) {
    world.tick();
    for (const auto& vehicle : vehicles) {
      vehicle->advance(world.now());
    }
  }
  std::vector<support::Trace> traces;
  for (const auto& vehicle : vehicles) {
    traces.push_back(vehicle->finish());
  }
  return traces;
}

/// Three vehicles: two start at the origin, the third a kilometre north.
std::vector<support::Trace> flyThree() {
  World world(setup().scenario);
  std::vector<std::unique_ptr<SimulatedVehicle>> vehicles;
  vehicles.push_back(made(setup(), world, 0));
  vehicles.push_back(made(setup(), world, 1));
  vehicles.push_back(made(setup(kKilometreNorth_deg), world, 2));
  return flyTogether(world, std::move(vehicles));
}

TEST(SharedWorld, TheFirstVehicleFliesAsItDoesAlone) {
  EXPECT_EQ(traceToCsv(flyThree()[0]), traceToCsv(fly(setup())));
}

TEST(SharedWorld, EachVehicleHasNoiseOfItsOwn) {
  const std::vector<support::Trace> traces = flyThree();
  const auto error = [&](size_t vehicle, double time_s) {
    return valueAt(traces[vehicle], "m_depth", time_s) -
           valueAt(traces[vehicle], "true_depth", time_s);
  };
  int same = 0;
  for (double time_s = 300; time_s < 700; time_s += 20) {
    same += error(0, time_s) == error(1, time_s) || error(1, time_s) == error(2, time_s) ? 1 : 0;
  }
  EXPECT_EQ(same, 0);
  EXPECT_EQ(traces[0].seed, traces[1].seed) << "the seed is that of the world";
}

TEST(SharedWorld, PositionsHaveOneOriginAndDeadReckoningTheVehiclesOwn) {
  const std::vector<support::Trace> traces = flyThree();
  EXPECT_EQ(valueAt(traces[1], "true_y", 0), 0);
  EXPECT_NEAR(valueAt(traces[2], "true_y", 0), 1000, 3);
  EXPECT_NEAR(valueAt(traces[2], "true_lat", 0) - valueAt(traces[0], "true_lat", 0),
              kKilometreNorth_deg, 1e-6);
  EXPECT_NEAR(valueAt(traces[2], "m_lat", 0), valueAt(traces[2], "true_lat", 0), 1e-4);
  EXPECT_NEAR(valueAt(traces[2], "m_y_lmc", 0), 0, 20) << "a fix of GPS is off by less";
  // The bottom is one: it slopes down to the south-east, so there is less water in the north.
  EXPECT_LT(valueAt(traces[2], "water_depth", 0), valueAt(traces[0], "water_depth", 0) - 2);
}

TEST(SharedWorld, AVehicleIsBroughtToTheTimeOfTheWorldAndNoFurther) {
  World world(setup().scenario);
  const auto often = made(setup(), world, 0), rarely = made(setup(), world, 0);
  for (int i = 0; i < 41; ++i) {
    world.tick();
    often->advance(world.now());
  }
  EXPECT_EQ(world.now(), 10.25);
  rarely->advance(world.now());
  rarely->advance(world.now());  // nothing is left to do
  const support::Trace one = often->finish(), other = rarely->finish();
  EXPECT_EQ(one.rowCount(), 3U) << "at 0, 4 and 8 s";
  EXPECT_EQ(traceToCsv(one), traceToCsv(other));
}

}  // namespace
}  // namespace glider::simulator
