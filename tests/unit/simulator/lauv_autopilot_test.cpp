// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// When the simulated LAUV goes to a place, and when it flies around it: as an unmodified DUNE does
// (scripts/soak/dune).

#include "hooks/imc/values.h"
#include "simulator/lauv/autopilot.h"
#include "tests/unit/simulator/propelled_vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glider::simulator::lauv {
namespace {

using hooks::imc::FollowState;

/// The vehicle under its autopilot in deep water.
struct AutopilotBench {
  Vehicle vehicle{propelledPlatform("lauv"),
                  propelledSettings(propelledPlatform("lauv"), buoyancyOf("lauv"))};
  Ocean ocean{propelledWater(500)};
  Autopilot autopilot;
  Target target{.place = {0, 200}, .depth_m = 0, .speed_mps = 1.2};
  double now_s = 0;
  uint8_t doing = FollowState::Wait;

  void fly(double seconds) {
    for (const double end_s = now_s + seconds; now_s < end_s; now_s += Vehicle::kStep) {
      doing = autopilot.steer(target, {vehicle.x(), vehicle.y()}, vehicle);
      vehicle.step(ocean, now_s);
    }
  }
  [[nodiscard]] double away() const {
    return std::hypot(target.place.east - vehicle.x(), target.place.north - vehicle.y());
  }
  /// Until the place is so near; false if it does not come so near within ten minutes.
  bool flyTo(double away_m) {
    for (int tenths = 0; tenths < 6000 && away() >= away_m; ++tenths) {
      fly(0.1);
    }
    return away() < away_m;
  }
};

TEST(LauvAutopilot, GoesStraightToAPlaceUntilItIsFiveSecondsBeforeIt) {
  AutopilotBench bench;
  bench.target.depth_m = 8;
  ASSERT_TRUE(bench.flyTo(6.5));
  EXPECT_EQ(bench.doing, FollowState::Goto);
  EXPECT_NEAR(bench.vehicle.x(), 0, 0.5) << "it did not begin to circle";
  bench.fly(1);
  EXPECT_EQ(bench.doing, FollowState::Loiter);
  double farthest_m = 0, nearest_m = 100;
  bench.fly(60);
  for (int second = 0; second < 120; ++second) {
    bench.fly(1);
    farthest_m = std::max(farthest_m, bench.away());
    nearest_m = std::min(nearest_m, bench.away());
  }
  EXPECT_LT(farthest_m, 15);
  EXPECT_GT(nearest_m, 5);
  EXPECT_LT(farthest_m - nearest_m, 2) << "a circle";
}

TEST(LauvAutopilot, ANewTargetWithinFifteenMetresIsReached) {
  for (const double away_m : {20.0, 14.0}) {
    AutopilotBench bench;
    bench.target.depth_m = 8;
    ASSERT_TRUE(bench.flyTo(away_m));
    EXPECT_EQ(bench.doing, FollowState::Goto);
    bench.target.depth_m = 12;
    bench.fly(0.1);
    EXPECT_EQ(bench.doing, away_m > 15 ? FollowState::Goto : FollowState::Elevator);
    bench.fly(120);
    EXPECT_EQ(bench.doing, FollowState::Loiter);
    EXPECT_NEAR(bench.vehicle.depth(), 12, 1);
  }
}

/// DUNE's had 1.63 m/s after 17 s, 1.48 after 30 s and 1.21 after 150 s.
TEST(LauvAutopilot, OvershootsItsSpeedForAMinuteAfterAStart) {
  AutopilotBench bench;
  bench.target = {.place = {0, 2000}, .depth_m = 5, .speed_mps = 1.2};
  double fastest = 0;
  for (int second = 0; second < 60; ++second) {
    bench.fly(1);
    fastest = std::max(fastest, bench.vehicle.bodyVelocity().surge);
  }
  EXPECT_GT(fastest, 1.35);
  EXPECT_LT(fastest, 1.7);
  EXPECT_GT(bench.vehicle.bodyVelocity().surge, 1.22);
  bench.fly(90);
  EXPECT_NEAR(bench.vehicle.bodyVelocity().surge, 1.2, 0.01);
  EXPECT_NEAR(bench.vehicle.y(), 186, 5) << "as far as DUNE's";
}

TEST(LauvAutopilot, StopsAtTheSurfaceUntilItHasDriftedAway) {
  AutopilotBench bench;
  ASSERT_TRUE(bench.flyTo(5.9));
  bench.fly(30);
  EXPECT_EQ(bench.doing, FollowState::Hover);
  EXPECT_NEAR(bench.vehicle.rpm(), 0, 1);
  bench.target.place.north += 10;
  bench.fly(0.1);
  EXPECT_EQ(bench.doing, FollowState::Hover) << "another place, as near as that";
  bench.target.place.north += 30;
  bench.fly(0.1);
  EXPECT_EQ(bench.doing, FollowState::Goto);
}

TEST(LauvAutopilot, ComesUpInACircleWhereItIs) {
  AutopilotBench bench;
  bench.target.depth_m = 20;
  bench.fly(100);
  ASSERT_GT(bench.vehicle.depth(), 15);
  for (int second = 0; second < 150; ++second) {
    bench.target = {
        .place = {bench.vehicle.x(), bench.vehicle.y()}, .depth_m = 0, .speed_mps = 1.2};
    bench.fly(1);
    EXPECT_TRUE(bench.doing == FollowState::Elevator || bench.doing == FollowState::Hover);
  }
  EXPECT_EQ(bench.doing, FollowState::Hover);
  EXPECT_LT(bench.vehicle.depth(), 1);
}

}  // namespace
}  // namespace glider::simulator::lauv
