// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/bottom_memory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::hooks {
namespace {

constexpr double kHour = 3600;

/// `north_m` north of 39 degrees and 10 minutes.
Position at(double north_m) {
  return {3910 + north_m / 1852, -7350};
}

void touch(BottomMemory& memory, const Position& where, double depth_m) {
  memory.observe(where, kShallowM, kHour);
  memory.touch(depth_m);
}

TEST(Position, DistancesAreThoseOnTheEarth) {
  EXPECT_NEAR(distanceBetween(at(0), at(1852)), 1852, 1);
  EXPECT_NEAR(distanceBetween({3910, -7350}, {3910, -7351}), 1852 * std::cos(0.6836), 3);
  EXPECT_NEAR(distanceBetween({3959.5, -7350}, {4000.5, -7350}), 1852, 1) << "over a whole degree";
  EXPECT_NEAR(distanceBetween({-10, 17959}, {-10, -17959}), 2 * 1852, 10) << "the date line";
  EXPECT_NEAR(distanceBetween({-30, -10}, {30, -10}), 111120, 10) << "the equator";
  EXPECT_NEAR(distanceBetween({8959, 0}, {8959, 9000}), 0, 70000) << "near the pole";
}

TEST(Position, AnUnknownOneIsNear) {
  const double nan = std::nan("");
  EXPECT_EQ(distanceBetween({nan, 0}, {3910, 0}), 0);
  EXPECT_EQ(distanceBetween({3910, nan}, {3910, 0}), 0);
  EXPECT_EQ(distanceBetween({3910, 0}, {9100, 0}), 0) << "not on Earth";
  EXPECT_EQ(distanceBetween({3910, 0}, {3910, 1e300}), 0);
}

TEST(BottomMemory, FadesWithTheDistanceOnly) {
  BottomMemory memory;
  EXPECT_FALSE(isKnown(memory.floor()));
  touch(memory, at(0), 40);
  memory.observe(at(0), kShallowM, 100 * kHour);
  EXPECT_EQ(memory.floor(), 40);
  memory.observe(at(2990), kShallowM, 4);
  EXPECT_EQ(memory.floor(), 40);
  memory.observe(at(4000), kShallowM, 4);
  EXPECT_NEAR(memory.floor(), 50, 0.1);
  memory.observe({}, kShallowM, 4);
  EXPECT_EQ(memory.floor(), 40) << "an unknown position is near";
}

TEST(BottomMemory, AnEchoIsNoContact) {
  BottomMemory memory;
  touch(memory, at(0), 50);
  memory.observe(at(185), kShallowM, 600);
  memory.keepEcho(20);
  EXPECT_EQ(memory.floor(), 20);
  EXPECT_EQ(memory.touchedFloor(), 50);
  EXPECT_EQ(memory.touchedHere(), 50);
  memory.forgetEchoes();
  EXPECT_EQ(memory.floor(), 50);
}

TEST(BottomMemory, AContactWithoutAPositionIsWhereTheVehicleIsFirstSeenAfterwards) {
  BottomMemory memory;
  touch(memory, {}, 20);
  memory.observe(at(0), kShallowM, 60);
  memory.observe(at(0), kShallowM, kHour);
  memory.observe(at(10000), kShallowM, 2 * kHour);
  EXPECT_NEAR(memory.floor(), 20 + 70, 0.1);
}

TEST(BottomMemory, AContactWithoutAPositionLeavesAPlaceWhereItWas) {
  BottomMemory memory;
  touch(memory, at(0), 40);
  touch(memory, {}, 30);
  memory.observe(at(10000), kShallowM, 3 * kHour);
  EXPECT_NEAR(memory.floor(), 30 + 70, 0.1);
}

TEST(BottomMemory, NoPositionIsFartherThanTheVehicleCanHaveCome) {
  BottomMemory memory;
  touch(memory, at(0), 40);
  memory.observe(at(50000), kShallowM, 1000);
  EXPECT_EQ(memory.floor(), 40);
  memory.observe(at(50000), kShallowM, 2000);
  EXPECT_NEAR(memory.floor(), 55, 0.1) << "4,500 m";
}

TEST(BottomMemory, ARisingBottomRisesOnToHalfTheDepth) {
  BottomMemory memory;
  memory.observe(at(-100), kShallowM, 4);
  memory.noteDive(45);  // and the bottom was deeper
  touch(memory, at(0), 40);
  memory.observe(at(100), kShallowM, kHour);
  EXPECT_NEAR(memory.floor(), 25, 0.1);
  memory.observe(at(1000), kShallowM, kHour);
  EXPECT_EQ(memory.floor(), 20);
}

TEST(BottomMemory, AtOnePlaceTheShallowerCounts) {
  BottomMemory memory;
  touch(memory, at(0), 40);
  touch(memory, at(300), 35);
  touch(memory, at(400), 45);
  memory.observe(at(400), kShallowM, 4);
  EXPECT_EQ(memory.floor(), 35);
  EXPECT_EQ(memory.touchedHere(), 35);
}

TEST(BottomMemory, HoldsEightPlaces) {
  BottomMemory memory;
  for (int i = 0; i < 9; ++i) {
    memory.observe(at(i * 10000), kShallowM, 10 * kHour);
    touch(memory, at(i * 10000), 40 + i);
  }
  for (int i = 1; i < 9; ++i) {
    memory.observe(at(i * 10000), kShallowM, 10 * kHour);
    EXPECT_EQ(memory.floor(), 40 + i) << i;
  }
  memory.observe(at(0), kShallowM, 10 * kHour);
  EXPECT_GT(memory.floor(), 41) << "the farthest was replaced";
}

TEST(BottomMemory, AVeryShallowPlaceIsForgottenAfterHalfAnHour) {
  BottomMemory memory;
  touch(memory, at(0), 12);
  memory.observe(at(0), kShallowM, 1800);
  EXPECT_EQ(memory.floor(), 12);
  memory.observe(at(0), kShallowM, 4);
  EXPECT_FALSE(isKnown(memory.floor()));
}

TEST(BottomMemory, APlaceTooShallowToDiveIsForgotten) {
  for (const double shallow_m : {kShallowM, 18.0}) {
    BottomMemory memory;
    touch(memory, at(0), 17);
    memory.observe(at(0), shallow_m, 1804);
    EXPECT_EQ(isKnown(memory.floor()), shallow_m < 17);
  }
}

TEST(BottomMemory, EchoesAreForgottenWhereContactsAreNot) {
  BottomMemory memory;
  memory.observe(at(0), kShallowM, 4);
  memory.keepEcho(30);
  touch(memory, at(2000), 40);
  memory.observe(at(2000), kShallowM, 2 * kHour);
  EXPECT_EQ(memory.floor(), 30);
  EXPECT_EQ(memory.touchedFloor(), 40);
  memory.forgetEchoes();
  EXPECT_EQ(memory.floor(), 40);
}

TEST(BottomMemory, TwoContactsGiveASlope) {
  for (const auto& [second_m, floor_m] : {std::pair{40.0, 32.5}, {55.0, 50.0}}) {
    BottomMemory memory;
    touch(memory, at(0), 50);
    touch(memory, at(600), second_m);
    memory.observe(at(900), kShallowM, kHour);
    EXPECT_NEAR(memory.floor(), floor_m, 0.1) << "it rises on half as steeply again, or falls";
  }
}

TEST(BottomMemory, TwoContactsAtOnePositionGiveNoSlope) {
  BottomMemory memory;
  touch(memory, at(0), 50);
  touch(memory, at(20), 40);
  memory.observe(at(300), kShallowM, kHour);
  EXPECT_EQ(memory.floor(), 40);
}

}  // namespace
}  // namespace glider::hooks
