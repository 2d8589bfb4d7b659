// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bottom_memory.h"

#include "tests/unit/hooks/begun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glider::hooks {
namespace {

constexpr double kHour = 3600;

constexpr HookPosition kNowhere{std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::quiet_NaN()};

/// `north_m` north of 39 degrees and 10 minutes.
HookPosition at(double north_m) {
  return {3910 + north_m / 1852, -7350};
}

void touch(HookBottomMemory& memory, const HookPosition& where, double depth_m) {
  hookBottomMemoryObserve(&memory, where, kHookShallowM, kHour);
  hookBottomMemoryTouch(&memory, depth_m);
}

TEST(Position, DistancesAreThoseOnTheEarth) {
  EXPECT_NEAR(hookDistanceBetween(at(0), at(1852)), 1852, 1);
  EXPECT_NEAR(hookDistanceBetween({3910, -7350}, {3910, -7351}), 1852 * std::cos(0.6836), 3);
  EXPECT_NEAR(hookDistanceBetween({3959.5, -7350}, {4000.5, -7350}), 1852, 1)
      << "over a whole degree";
  EXPECT_NEAR(hookDistanceBetween({-10, 17959}, {-10, -17959}), 2 * 1852, 10) << "the date line";
  EXPECT_NEAR(hookDistanceBetween({-30, -10}, {30, -10}), 111120, 10) << "the equator";
  EXPECT_NEAR(hookDistanceBetween({8959, 0}, {8959, 9000}), 0, 70000) << "near the pole";
}

TEST(Position, AnUnknownOneIsNear) {
  const double nan = std::nan("");
  EXPECT_EQ(hookDistanceBetween({nan, 0}, {3910, 0}), 0);
  EXPECT_EQ(hookDistanceBetween({3910, nan}, {3910, 0}), 0);
  EXPECT_EQ(hookDistanceBetween({3910, 0}, {9100, 0}), 0) << "not on Earth";
  EXPECT_EQ(hookDistanceBetween({3910, 0}, {3910, 1e300}), 0);
}

TEST(BottomMemory, FadesWithTheDistanceOnly) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  EXPECT_FALSE(hookIsFloorKnown(hookBottomMemoryFloor(&memory, false)));
  touch(memory, at(0), 40);
  hookBottomMemoryObserve(&memory, at(0), kHookShallowM, 100 * kHour);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 40);
  hookBottomMemoryObserve(&memory, at(2990), kHookShallowM, 4);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 40);
  hookBottomMemoryObserve(&memory, at(4000), kHookShallowM, 4);
  EXPECT_NEAR(hookBottomMemoryFloor(&memory, false), 50, 0.1);
  hookBottomMemoryObserve(&memory, kNowhere, kHookShallowM, 4);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 40) << "an unknown position is near";
}

TEST(BottomMemory, AnEchoIsNoContact) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  touch(memory, at(0), 50);
  hookBottomMemoryObserve(&memory, at(185), kHookShallowM, 600);
  hookBottomMemoryKeepEcho(&memory, 20);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 20);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, true), 50);
  EXPECT_EQ(hookBottomMemoryTouchedHere(&memory), 50);
  hookBottomMemoryForgetEchoes(&memory);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 50);
}

TEST(BottomMemory, AContactWithoutAPositionIsWhereTheVehicleIsFirstSeenAfterwards) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  touch(memory, kNowhere, 20);
  hookBottomMemoryObserve(&memory, at(0), kHookShallowM, 60);
  hookBottomMemoryObserve(&memory, at(0), kHookShallowM, kHour);
  hookBottomMemoryObserve(&memory, at(10000), kHookShallowM, 2 * kHour);
  EXPECT_NEAR(hookBottomMemoryFloor(&memory, false), 20 + 70, 0.1);
}

TEST(BottomMemory, AContactWithoutAPositionLeavesAPlaceWhereItWas) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  touch(memory, at(0), 40);
  touch(memory, kNowhere, 30);
  hookBottomMemoryObserve(&memory, at(10000), kHookShallowM, 3 * kHour);
  EXPECT_NEAR(hookBottomMemoryFloor(&memory, false), 30 + 70, 0.1);
}

TEST(BottomMemory, NoPositionIsFartherThanTheVehicleCanHaveCome) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  touch(memory, at(0), 40);
  hookBottomMemoryObserve(&memory, at(50000), kHookShallowM, 1000);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 40);
  hookBottomMemoryObserve(&memory, at(50000), kHookShallowM, 2000);
  EXPECT_NEAR(hookBottomMemoryFloor(&memory, false), 55, 0.1) << "4,500 m";
}

TEST(BottomMemory, ARisingBottomRisesOnToHalfTheDepth) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  hookBottomMemoryObserve(&memory, at(-100), kHookShallowM, 4);
  hookBottomMemoryNoteDive(&memory, 45);  // and the bottom was deeper
  touch(memory, at(0), 40);
  hookBottomMemoryObserve(&memory, at(100), kHookShallowM, kHour);
  EXPECT_NEAR(hookBottomMemoryFloor(&memory, false), 25, 0.1);
  hookBottomMemoryObserve(&memory, at(1000), kHookShallowM, kHour);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 20);
}

TEST(BottomMemory, AtOnePlaceTheShallowerCounts) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  touch(memory, at(0), 40);
  touch(memory, at(300), 35);
  touch(memory, at(400), 45);
  hookBottomMemoryObserve(&memory, at(400), kHookShallowM, 4);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 35);
  EXPECT_EQ(hookBottomMemoryTouchedHere(&memory), 35);
}

TEST(BottomMemory, HoldsEightPlaces) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  for (int i = 0; i < 9; ++i) {
    hookBottomMemoryObserve(&memory, at(i * 10000), kHookShallowM, 10 * kHour);
    touch(memory, at(i * 10000), 40 + i);
  }
  for (int i = 1; i < 9; ++i) {
    hookBottomMemoryObserve(&memory, at(i * 10000), kHookShallowM, 10 * kHour);
    EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 40 + i) << i;
  }
  hookBottomMemoryObserve(&memory, at(0), kHookShallowM, 10 * kHour);
  EXPECT_GT(hookBottomMemoryFloor(&memory, false), 41) << "the farthest was replaced";
}

TEST(BottomMemory, AVeryShallowPlaceIsForgottenAfterHalfAnHour) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  touch(memory, at(0), 12);
  hookBottomMemoryObserve(&memory, at(0), kHookShallowM, 1800);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 12);
  hookBottomMemoryObserve(&memory, at(0), kHookShallowM, 4);
  EXPECT_FALSE(hookIsFloorKnown(hookBottomMemoryFloor(&memory, false)));
}

TEST(BottomMemory, APlaceTooShallowToDiveIsForgotten) {
  for (const double shallow_m : {kHookShallowM, 18.0}) {
    HookBottomMemory memory = begun(hookBottomMemoryInit);
    touch(memory, at(0), 17);
    hookBottomMemoryObserve(&memory, at(0), shallow_m, 1804);
    EXPECT_EQ(hookIsFloorKnown(hookBottomMemoryFloor(&memory, false)), shallow_m < 17);
  }
}

TEST(BottomMemory, EchoesAreForgottenWhereContactsAreNot) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  hookBottomMemoryObserve(&memory, at(0), kHookShallowM, 4);
  hookBottomMemoryKeepEcho(&memory, 30);
  touch(memory, at(2000), 40);
  hookBottomMemoryObserve(&memory, at(2000), kHookShallowM, 2 * kHour);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 30);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, true), 40);
  hookBottomMemoryForgetEchoes(&memory);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 40);
}

TEST(BottomMemory, TwoContactsGiveASlope) {
  for (const auto& [second_m, floor_m] : {std::pair{40.0, 32.5}, {55.0, 50.0}}) {
    HookBottomMemory memory = begun(hookBottomMemoryInit);
    touch(memory, at(0), 50);
    touch(memory, at(600), second_m);
    hookBottomMemoryObserve(&memory, at(900), kHookShallowM, kHour);
    EXPECT_NEAR(hookBottomMemoryFloor(&memory, false), floor_m, 0.1)
        << "it rises on half as steeply again, or falls";
  }
}

TEST(BottomMemory, TwoContactsAtOnePositionGiveNoSlope) {
  HookBottomMemory memory = begun(hookBottomMemoryInit);
  touch(memory, at(0), 50);
  touch(memory, at(20), 40);
  hookBottomMemoryObserve(&memory, at(300), kHookShallowM, kHour);
  EXPECT_EQ(hookBottomMemoryFloor(&memory, false), 40);
}

}  // namespace
}  // namespace glider::hooks
