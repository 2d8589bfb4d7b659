// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ocean/ocean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

OceanSettings twoLayers() {
  OceanSettings settings;
  settings.surface_temperature = 24;
  settings.bottom_temperature = 7;
  settings.thermocline_depth_m = 14;
  settings.thermocline_thickness_m = 2.5;
  settings.water_depth_m = 60;
  settings.wave = {.amplitude_m = 4, .period_s = 1200, .start_s = 260, .count = 1};
  return settings;
}

TEST(Ocean, IsWarmAboveAndColdBelow) {
  const Ocean ocean(twoLayers());
  EXPECT_NEAR(ocean.temperature(0, 0, 0, 0), 24, 0.01);
  EXPECT_NEAR(ocean.temperature(60, 0, 0, 0), 7, 0.01);
  EXPECT_NEAR(ocean.temperature(14, 0, 0, 0), 15.5, 1e-12);
  for (double z = 0; z < 60; z += 0.5) {
    EXPECT_GE(ocean.temperature(z, 0, 0, 500), ocean.temperature(z + 0.5, 0, 0, 500));
  }
}

TEST(Ocean, HasOneWaveThatIsNowhereElse) {
  const Ocean ocean(twoLayers());
  EXPECT_EQ(ocean.isothermDepth(15.5, 0, 0, 0), 14);
  EXPECT_EQ(ocean.isothermDepth(15.5, 0, 0, 1461), 14);
  EXPECT_EQ(ocean.verticalCurrent(14, 0, 0, 100), 0);
  const double lowest = ocean.isothermDepth(15.5, 0, 0, 260 + 300);
  const double highest = ocean.isothermDepth(15.5, 0, 0, 260 + 900);
  EXPECT_GT(lowest, 17);
  EXPECT_LT(lowest, 18);
  EXPECT_LT(highest, 11.5);
  EXPECT_GT(highest, 10);
}

TEST(Ocean, IsothermIsWhereTheTemperatureIs) {
  OceanSettings settings = twoLayers();
  settings.wave.wavelength_m = 500;
  settings.wave.count = 0;
  const Ocean ocean(settings);
  for (const double temperature : {8.0, 12.0, 15.5, 20.0, 23.5}) {
    for (double t = 0; t < 2400; t += 133) {
      for (const double x : {-700.0, 0.0, 123.0}) {
        const double z = ocean.isothermDepth(temperature, x, 0, t);
        ASSERT_FALSE(std::isnan(z));
        EXPECT_NEAR(ocean.temperature(z, x, 0, t), temperature, 1e-9);
      }
    }
  }
  EXPECT_TRUE(std::isnan(ocean.isothermDepth(30, 0, 0, 0)));
}

TEST(Ocean, WaterMovesWithTheWave) {
  const Ocean ocean(twoLayers());
  // A particle carried by the water stays on its isotherm.
  double z = 14;
  constexpr double kStep = 0.1;
  for (double t = 260; t < 560; t += kStep) {
    z -= ocean.verticalCurrent(z, 0, 0, t) * kStep;
  }
  EXPECT_NEAR(ocean.temperature(z, 0, 0, 560), 15.5, 1.5);
  EXPECT_GT(z, 16.5);
  EXPECT_EQ(ocean.verticalCurrent(0, 0, 0, 400), 0);
  EXPECT_NEAR(ocean.verticalCurrent(60, 0, 0, 400), 0, 1e-12);
}

TEST(Ocean, BottomMayBeWavy) {
  OceanSettings settings = twoLayers();
  settings.bottom_height_m = 5;
  settings.bottom_wavelength_m = 100;
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.waterDepth(25, 0), 55, 1e-9);
  EXPECT_NEAR(ocean.waterDepth(0, 75), 65, 1e-9);
}

}  // namespace
}  // namespace glider::simulator
