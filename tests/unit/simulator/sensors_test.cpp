// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/altimeter/altimeter.h"
#include "simulator/sensors/attitude/attitude_sensor.h"
#include "simulator/sensors/concentration_noise.h"
#include "simulator/sensors/depth/depth_sensor.h"
#include "simulator/sensors/gps/gps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::simulator {
namespace {

TEST(Noise, IsGaussianAndRepeatable) {
  Noise a(7, 1), b(7, 1), other_stream(7, 2), other_seed(8, 1);
  double sum = 0, squares = 0;
  bool differs = false;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double x = a.normal(2);
    EXPECT_EQ(x, b.normal(2));
    differs = differs || (x != other_stream.normal(2) && x != other_seed.normal(2));
    sum += x;
    squares += x * x;
  }
  EXPECT_TRUE(differs);
  EXPECT_NEAR(sum / kCount, 0, 0.05);
  EXPECT_NEAR(std::sqrt(squares / kCount), 2, 0.05);
}

TEST(Sensors, ReadTheTruthWithoutNoise) {
  EXPECT_EQ(DepthSensor(1, {.noise_m = 0}).pressure(12.5), 1.25);
  EXPECT_EQ(AttitudeSensor(1, {0, 0}).pitch(-0.4), -0.4);
  EXPECT_NEAR(AttitudeSensor(1, {0, 0}).heading(-0.1), 2 * std::numbers::pi - 0.1, 1e-12);
  EXPECT_EQ(Altimeter(1, {.noise_m = 0}).altitude(20, 50), 30);
}

TEST(Gps, TellsTheVariationToATenthOfADegree) {
  constexpr double kDegree = std::numbers::pi / 180;
  EXPECT_DOUBLE_EQ(Gps::variation(-12.35678 * kDegree), 12.4 * kDegree);
  EXPECT_DOUBLE_EQ(Gps::variation(16.71 * kDegree), -16.7 * kDegree);
}

TEST(Altimeter, HasNoEchoTooNearTooFarOrAtTheSurface) {
  Altimeter altimeter(1, {.noise_m = 0});
  EXPECT_TRUE(std::isnan(altimeter.altitude(49, 50)));
  EXPECT_TRUE(std::isnan(altimeter.altitude(20, 200)));
  EXPECT_TRUE(std::isnan(altimeter.altitude(1, 50)));
}

TEST(Gps, NeedsTimeAtTheSurface) {
  Gps gps(1, {.noise_m = 0});
  EXPECT_TRUE(gps.fix(3, 4, 0, 0)) << "the mission starts with a fix";
  EXPECT_FALSE(gps.fix(3, 4, 10, 100));
  EXPECT_FALSE(gps.fix(3, 4, 0, 110));
  const auto fix = gps.fix(3, 4, 0, 121);
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->x, 3);
  EXPECT_EQ(fix->y, 4);
}

TEST(Altimeter, ReachesAsFarAsTheScenarioSaysAndLosesEchoes) {
  Altimeter near(1, {.noise_m = 0, .range_m = 40});
  EXPECT_EQ(near.altitude(20, 60), 40);
  EXPECT_TRUE(std::isnan(near.altitude(20, 60.1)));
  Altimeter failing(1, {.noise_m = 0, .dropout = 0.25}), same(1, {.noise_m = 0, .dropout = 0.25});
  int lost = 0;
  for (int i = 0; i < 1000; ++i) {
    const bool none = std::isnan(failing.altitude(20, 50));
    EXPECT_EQ(none, std::isnan(same.altitude(20, 50)));
    lost += none ? 1 : 0;
  }
  EXPECT_NEAR(lost, 250, 50);
}

TEST(ConcentrationNoise, IsNoisyAndNeverNegative) {
  EXPECT_EQ(ConcentrationNoise(1, "sci_oxy4_oxygen", 0).read(3.5), 3.5);
  ConcentrationNoise a(1, "sci_oxy4_oxygen", 0.5), b(1, "sci_oxy4_oxygen", 0.5);
  int zeros = 0;
  for (int i = 0; i < 1000; ++i) {
    const double read = a.read(0);
    EXPECT_EQ(read, b.read(0));
    EXPECT_GE(read, 0);
    zeros += read == 0 ? 1 : 0;
  }
  EXPECT_NEAR(zeros, 500, 60);
}

}  // namespace
}  // namespace glider::simulator
