// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Several vehicles in one world: one clock, one origin, one water, random numbers of their own.

#include "simulator/fleet/fleet.h"
#include "simulator/simulated_vehicle.h"
#include "simulator/simulator.h"
#include "tests/unit/simulator/fleet_traces.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

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

/// Three vehicles: two start at the origin, the third a kilometre north.
FleetFlight flyFleetOfThree() {
  std::vector<FleetMember> members;
  members.push_back({setup(), 0});
  members.push_back({setup(), 1});
  members.push_back({setup(kKilometreNorth_deg), 2});
  auto flight = simulateFleet(setup().scenario, std::move(members));
  EXPECT_TRUE(flight.has_value());
  return flight ? std::move(*flight) : FleetFlight{{}, Separations(0), {}};
}

std::vector<support::Trace> flyThree() {
  return tracesOf(flyFleetOfThree());
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

TEST(SharedWorld, PositionsInATraceAreRelativeToTheVehiclesOwnStart) {
  const FleetFlight flight = flyFleetOfThree();
  const std::vector<support::Trace> traces = tracesOf(flight);
  EXPECT_EQ(flight.starts[1].north_m, 0);
  EXPECT_NEAR(flight.starts[2].north_m, 1000, 3);
  EXPECT_EQ(valueAt(traces[1], "true_y", 0), 0);
  EXPECT_EQ(valueAt(traces[2], "true_y", 0), 0);
  EXPECT_NEAR(valueAt(traces[2], "true_lat", 0) - valueAt(traces[0], "true_lat", 0),
              kKilometreNorth_deg, 1e-6);
  EXPECT_NEAR(valueAt(traces[2], "m_lat", 0), valueAt(traces[2], "true_lat", 0), 1e-4);
  EXPECT_NEAR(valueAt(traces[2], "m_y_lmc", 0), 0, 20) << "a fix of GPS is off by less";
  // The bottom is one: it slopes down to the south-east, so there is less water in the north.
  EXPECT_LT(valueAt(traces[2], "water_depth", 0), valueAt(traces[0], "water_depth", 0) - 2);
}

TEST(SharedWorld, TheDistanceOfVehiclesThatStartAKilometreApartIsMeasured) {
  const FleetFlight flight = flyFleetOfThree();
  const std::vector<PairDistance>& pairs = flight.separations.pairs();
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_LT(pairs[0].least_m, 1) << "the first two start at one place";
  EXPECT_NEAR(pairs[1].least_m, 1000, 60);
  EXPECT_EQ(pairs[2].pair, (VehiclePair{1, 2}));
}

TEST(SharedWorld, AVehicleFliesAsItDoesWithoutTheOthers) {
  std::vector<FleetMember> only;
  only.push_back({setup(kKilometreNorth_deg), 2});
  const auto alone = simulateFleet(setup().scenario, std::move(only));
  ASSERT_TRUE(alone.has_value());
  EXPECT_EQ(traceToCsv(alone->take(0)), traceToCsv(flyThree()[2]));
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
