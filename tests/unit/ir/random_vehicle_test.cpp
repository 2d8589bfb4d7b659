// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The vehicle of random flights does all that the platform says it may, and no more: what it never
// does no flight finds.

#include "ir/prove/falsification/random_vehicle.h"

#include "tests/unit/ir/slocum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace glider::ir::prove {
namespace {

// Of the platform: control is given at 3 m or above, 5 m are overshot, it sinks at 0.4 m/s at most
// and climbs at 0.05 m/s at least, from 120 s after the command on.
constexpr double kLongFlight = 4000;  // s, more than it needs to get anywhere

Action commanded(Command command, std::vector<double> arguments = {}, bool refused = false) {
  return CommandRun{command, std::move(arguments), refused};
}

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

using VehicleFlight = std::function<void(RandomVehicle&)>;

/// Where it is after a flight, of many vehicles.
Range depthsAfter(const VehicleFlight& flight, Manner manner = Manner::Any) {
  Range all;
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    Rng dice(seed);
    RandomVehicle vehicle(slocum(), dice, manner);
    flight(vehicle);
    all.least = std::min(all.least, vehicle.depth());
    all.most = std::max(all.most, vehicle.depth());
  }
  return all;
}

void fly(RandomVehicle& vehicle, double from, double to) {
  for (double now = from; now < to; now += 20) {
    vehicle.move(now, std::min(now + 20, to));
  }
}

/// After these commands have been in force for long.
Range depthsUnder(const std::vector<Action>& commands) {
  return depthsAfter([&](RandomVehicle& vehicle) {
    vehicle.obey(commands, 0);
    fly(vehicle, 0, kLongFlight);
  });
}

void expectUpTo(double deepest, const Range& range) {
  EXPECT_LE(range.most, deepest);
  EXPECT_GT(range.most, deepest - 0.5);
}

TEST(RandomVehicle, BeginsNearTheSurface) {
  const Range start = depthsAfter([](RandomVehicle&) {});
  EXPECT_GE(start.least, 0);
  expectUpTo(3, start);
  expectUpTo(8, depthsUnder({}));
}

TEST(RandomVehicle, SinksToWhatIsCommanded) {
  expectUpTo(25, depthsUnder({commanded(Command::Descend, {20, 0.4})}));
  expectUpTo(25, depthsUnder({commanded(Command::Hover, {20})}));
  expectUpTo(205, depthsUnder({commanded(Command::Pump, {-0.0001})}));
  expectUpTo(205, depthsUnder({commanded(Command::Battery, {0})}));
  expectUpTo(8, depthsUnder({commanded(Command::Pump, {0}, true)}));
  expectUpTo(8, depthsUnder({commanded(Command::Descend, {20, 0.4}, true)}));
  expectUpTo(8, depthsUnder({commanded(Command::Drift)}));
  expectUpTo(25, depthsUnder({commanded(Command::Descend, {50, 0.4}),
                              commanded(Command::Descend, {20, 0.4})}));
}

TEST(RandomVehicle, GoesOnFromWhereItIs) {
  // From about 55 m, commanded to no more than 20 m, it may overshoot by 5 m first.
  const Range range = depthsAfter([](RandomVehicle& vehicle) {
    vehicle.obey({commanded(Command::Descend, {50, 0.4})}, 0);
    fly(vehicle, 0, kLongFlight);
    vehicle.obey({commanded(Command::Descend, {20, 0.4})}, kLongFlight);
    fly(vehicle, kLongFlight, 2 * kLongFlight);
  });
  expectUpTo(55, range);
}

TEST(RandomVehicle, OvershootsWhereItIsTurned) {
  // 80 s of sinking by 0.4 m/s, 24 s more until the command takes effect, and the overshoot.
  expectUpTo(3 + 32 + 9.6 + 5, depthsAfter([](RandomVehicle& vehicle) {
               vehicle.obey({commanded(Command::Descend, {50, 0.4})}, 0);
               fly(vehicle, 0, 80);
               vehicle.obey({commanded(Command::Descend, {20, 0.4})}, 80);
               fly(vehicle, 80, kLongFlight);
             }));
}

/// From 50 m and what is overshot, `seconds` after a command to climb.
Range depthsAfterClimb(const Action& climb, double seconds, Manner manner = Manner::Any) {
  const auto flight = [&](RandomVehicle& vehicle) {
    vehicle.obey({commanded(Command::Descend, {50, 0.4})}, 0);
    fly(vehicle, 0, kLongFlight);
    vehicle.obey({climb}, kLongFlight);
    fly(vehicle, kLongFlight, kLongFlight + seconds);
  };
  return depthsAfter(flight, manner);
}

TEST(RandomVehicle, ClimbsAtLeastAsFastAsItMust) {
  const Action surface = commanded(Command::Surface);
  expectUpTo(55, depthsAfterClimb(surface, 100));
  expectUpTo(55, depthsAfterClimb(surface, 120));
  expectUpTo(50, depthsAfterClimb(surface, 220));
  expectUpTo(5, depthsAfterClimb(surface, 1120));
  EXPECT_EQ(depthsAfterClimb(surface, 1220).most, 0);
  EXPECT_EQ(depthsAfterClimb(surface, 160).least, 0) << "or as fast as it can";
}

TEST(RandomVehicle, ClimbsToWhatIsCommanded) {
  const Range there = depthsAfterClimb(commanded(Command::Ascend, {20, 0.4}), kLongFlight);
  expectUpTo(25, there);
  EXPECT_EQ(depthsAfterClimb(commanded(Command::Ascend, {0, 0.4}), kLongFlight).most, 0);
}

TEST(RandomVehicle, AShyOneComesNoNearerToTheSurfaceThanCommanded) {
  const Action climb = commanded(Command::Ascend, {5, 0.4});
  EXPECT_GE(depthsAfterClimb(climb, 400, Manner::Shy).least, 5);
  EXPECT_LT(depthsAfterClimb(climb, 400, Manner::Shy).least, 5.5) << "it does come there";
  EXPECT_LT(depthsAfterClimb(climb, 400).least, 4) << "another may go on";
}

TEST(RandomVehicle, AShyOneClimbsToTheSurfaceAsLateAsItMay) {
  const Action surface = commanded(Command::Surface);
  for (const double seconds : {220.0, 500.0, 1120.0}) {
    const double latest = 55 - 0.05 * (seconds - 120);
    EXPECT_GT(depthsAfterClimb(surface, seconds, Manner::Shy).most, latest - 0.5);
    EXPECT_LE(depthsAfterClimb(surface, seconds, Manner::Shy).most, latest);
  }
  EXPECT_EQ(depthsAfterClimb(surface, 120, Manner::Shy).least,
            depthsAfterClimb(surface, 100, Manner::Shy).least)
      << "before it must, none climbs";
}

TEST(RandomVehicle, DoesNotTurnBackOnItsWayUp) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Rng dice(seed);
    RandomVehicle vehicle(slocum(), dice);
    vehicle.obey({commanded(Command::Descend, {50, 0.4})}, 0);
    fly(vehicle, 0, kLongFlight);
    vehicle.obey({commanded(Command::Surface)}, kLongFlight);
    bool rose = false;
    for (double now = kLongFlight; now < kLongFlight + 1220; now += 20) {
      const double before = vehicle.depth();
      vehicle.move(now, now + 20);
      EXPECT_TRUE(!rose || vehicle.depth() <= before) << seed;
      rose = rose || vehicle.depth() < before;
    }
    EXPECT_TRUE(rose);
  }
}

TEST(RandomVehicle, AboveWhereItClimbsToItMaySinkOrNot) {
  const Range there = depthsUnder({commanded(Command::Ascend, {20, 0.4})});
  EXPECT_LT(there.least, 10);
  EXPECT_GT(there.most, 15);
}

TEST(RandomVehicle, DoesNotLeaveTheWater) {
  const Range there = depthsAfterClimb(commanded(Command::Ascend, {-3, 0.4}), kLongFlight);
  EXPECT_EQ(there.least, 0);
  EXPECT_EQ(there.most, 0);
}

TEST(RandomVehicle, AnotherCommandToClimbIsTheSame) {
  const Range range = depthsAfter([](RandomVehicle& vehicle) {
    vehicle.obey({commanded(Command::Descend, {50, 0.4})}, 0);
    fly(vehicle, 0, kLongFlight);
    for (double now = kLongFlight; now < kLongFlight + 1220; now += 20) {
      vehicle.obey({commanded(Command::Surface)}, now);
      vehicle.move(now, now + 20);
    }
  });
  EXPECT_EQ(range.most, 0) << "its turn does not start again";
}

TEST(RandomVehicle, IsNoFasterThanItCanBe) {
  double fastest = 0;
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    Rng dice(seed);
    RandomVehicle vehicle(slocum(), dice);
    vehicle.obey({commanded(Command::Descend, {100, 0.4})}, 0);
    for (double now = 0; now < 100; ++now) {
      const double before = vehicle.depth();
      vehicle.move(now, now + 1);
      fastest = std::max(fastest, std::fabs(vehicle.depth() - before));
    }
  }
  EXPECT_NEAR(fastest, 0.4, 1e-9);
}

TEST(RandomVehicle, IsAsSlowAsItLikes) {
  const Range sunk = depthsAfter([](RandomVehicle& vehicle) {
    vehicle.obey({commanded(Command::Descend, {100, 0.4})}, 0);
    fly(vehicle, 0, 20);
  });
  EXPECT_LT(sunk.least, 1);
  expectUpTo(3 + 8, sunk);
}

TEST(RandomVehicle, ShowsItsDepthRoughly) {
  Range error;
  for (uint64_t seed = 1; seed <= 1000; ++seed) {
    Rng dice(seed);
    RandomVehicle vehicle(slocum(), dice);
    const double shown = vehicle.reading();
    EXPECT_GE(shown, 0);
    if (vehicle.depth() > 0.9) {
      error.least = std::min(error.least, shown - vehicle.depth());
      error.most = std::max(error.most, shown - vehicle.depth());
    }
  }
  EXPECT_NEAR(error.least, -0.9, 0.02);
  EXPECT_NEAR(error.most, 0.9, 0.02);
}

/// Limits that are NaN would allow every depth.
TEST(DepthLimits, OfACommandThatIsRefusedThereAreNone) {
  DepthLimits limits(slocum(), 0);
  const CommandRun refused{Command::Descend, {std::numeric_limits<double>::quiet_NaN()}, true};
  EXPECT_DEATH(limits.obey(refused, 4), "unknown target");
}

TEST(RandomVehicle, WhatIsInCMayCommandAnything) {
  const Range range = depthsUnder({ActivityRun{ListKind::Profile, {0}, Phase::Tick, {}}});
  EXPECT_GT(range.most, 190);
  EXPECT_LE(range.most, 208);
  EXPECT_EQ(range.least, 0);
}

}  // namespace
}  // namespace glider::ir::prove
