// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pressure of a swell at a vehicle, by the textbook's formulas, and cycles of unequal length.

#include "simulator/ocean/ocean.h"
#include "simulator/seat/cycle_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace glider::simulator {
namespace {

Ocean oceanWith(double amplitude_m, double period_s, double water_m, double followed = 1) {
  OceanSettings settings;
  settings.bottom.depth_m = water_m;
  settings.swell = {.amplitude_m = amplitude_m, .period_s = period_s, .followed_share = followed};
  return Ocean(settings);
}

/// The greatest pressure of a wave at the depth z, m of water.
double most(const Ocean& ocean, double z) {
  double greatest = 0;
  for (int i = 0; i < 1000; ++i) {
    greatest = std::max(greatest, ocean.swellPressure(z, 0, 0, i * 0.02));
  }
  return greatest;
}

TEST(Swell, AVehicleThatFollowsDeepWaterFeelsNone) {
  EXPECT_LT(most(oceanWith(1, 8, 500), 0), 1e-9);
  EXPECT_LT(most(oceanWith(1, 8, 500), 20), 1e-9);
}

TEST(Swell, ItsPressureDecaysAsTheOrbits) {
  const double omega = 2 * std::numbers::pi / 8;
  const double k = omega * omega / 9.81;  // deep water
  for (const double z : {0.0, 5.0, 30.0}) {
    EXPECT_NEAR(most(oceanWith(0.7, 8, 500, 0), z), 0.7 * std::exp(-k * z), 1e-4) << z;
  }
}

TEST(Swell, OnAShelfThePressureReachesTheBottom) {
  const double water = 30, omega = 2 * std::numbers::pi / 12;
  double k = 0.01;  // by bisection: omega^2 = g k tanh(k h)
  for (double step = 0.1; step > 1e-12; step /= 2) {
    k += 9.81 * (k + step) * std::tanh((k + step) * water) < omega * omega ? step : 0;
  }
  EXPECT_NEAR(most(oceanWith(1, 12, water), water), 1 / std::cosh(k * water), 1e-4);
  EXPECT_GT(most(oceanWith(1, 12, water), water), 0.5);
  const double pressure = std::cosh(k * 20) / std::cosh(k * water);
  const double motion = std::sinh(k * 20) / std::sinh(k * water);
  EXPECT_NEAR(most(oceanWith(1, 12, water), 10), pressure - motion, 1e-4);
}

TEST(Swell, TravelsToItsBearing) {
  OceanSettings settings;
  settings.bottom.depth_m = 500;
  settings.swell = {
      .amplitude_m = 1, .period_s = 10, .bearing_rad = std::numbers::pi / 2, .followed_share = 0};
  const Ocean ocean(settings);
  const double omega = 2 * std::numbers::pi / 10;
  const double length = 2 * std::numbers::pi / (omega * omega / 9.81);
  EXPECT_NEAR(ocean.swellPressure(0, length / 4, 0, 2.5), 1, 1e-3) << "a quarter of each";
  EXPECT_NEAR(ocean.swellPressure(0, 0, 33, 0), 1, 1e-9) << "the same along the crest";
}

/// Mean and greatest of many cycles, s.
std::pair<double, double> cyclesOf(const CycleSettings& settings) {
  CycleTimes times(settings, 4, 0.25, 7);
  double sum = 0, greatest = 0;
  for (int i = 0; i < 5000; ++i) {
    const double secs = 0.25 * static_cast<double>(times.steps());
    sum += secs;
    greatest = std::max(greatest, secs);
  }
  return {sum / 5000, greatest};
}

TEST(CycleTimes, AreThoseOfThePlatformUnlessTheScenarioSaysOtherwise) {
  EXPECT_EQ(cyclesOf({}), std::pair(4.0, 4.0));
}

TEST(CycleTimes, SomeAreLong) {
  const auto [mean, greatest] = cyclesOf({4.4, 0.2, 0.05, 15});
  EXPECT_NEAR(mean, 0.95 * 4.4 + 0.05 * 15, 0.15);
  EXPECT_EQ(greatest, 15);
}

}  // namespace
}  // namespace glider::simulator
