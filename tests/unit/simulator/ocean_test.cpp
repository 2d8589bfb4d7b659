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
  settings.bottom.depth_m = 60;
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

TEST(Ocean, IsDenserBelowWhereThereIsAPycnocline) {
  OceanSettings settings = twoLayers();
  EXPECT_EQ(Ocean(settings).density(3, 0, 0, 0), 1025);
  EXPECT_EQ(Ocean(settings).density(50, 0, 0, 0), 1025) << "without a step";
  settings.density_step = 4;
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.density(0, 0, 0, 0), 1023, 0.01);
  EXPECT_NEAR(ocean.density(60, 0, 0, 0), 1027, 0.01);
  EXPECT_NEAR(ocean.density(14, 0, 0, 0), 1025, 1e-9);
  EXPECT_LT(ocean.density(16, 0, 0, 260 + 300), ocean.density(16, 0, 0, 0)) << "the wave lowers it";
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
  settings.bottom.wave_height_m = 5;
  settings.bottom.wave_length_m = 100;
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.waterDepth(25, 0), 55, 1e-9);
  EXPECT_NEAR(ocean.waterDepth(0, 75), 65, 1e-9);
}

TEST(Ocean, BottomSlopesTowardsItsBearing) {
  OceanSettings settings = twoLayers();
  settings.bottom.slope = 0.008;
  settings.bottom.slope_bearing_rad = std::numbers::pi / 2;
  const Ocean east(settings);
  EXPECT_NEAR(east.waterDepth(1000, 0), 68, 1e-9);
  EXPECT_NEAR(east.waterDepth(0, 1000), 60, 1e-9);
  EXPECT_NEAR(east.waterDepth(-1000, 0), 52, 1e-9);
  EXPECT_EQ(east.waterDepth(-9000, 0), 0) << "land";
  settings.bottom.slope_bearing_rad = std::numbers::pi / 6;
  EXPECT_NEAR(Ocean(settings).waterDepth(0, 1000), 60 + 8 * std::cos(std::numbers::pi / 6), 1e-9);
}

TEST(Ocean, BottomHasSeamounts) {
  OceanSettings settings = twoLayers();
  settings.bottom.seamounts = {{.x = 600, .y = -100, .radius_m = 200, .height_m = 20}};
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.waterDepth(600, -100), 40, 1e-9);
  EXPECT_NEAR(ocean.waterDepth(600, 100), 60 - 20 / std::numbers::e, 1e-9);
  EXPECT_NEAR(ocean.waterDepth(-2000, 0), 60, 1e-9);
}

TEST(Ocean, WaveEndsWhereTheBottomRisesToTheThermocline) {
  OceanSettings settings = twoLayers();
  settings.wave.count = 0;
  settings.bottom.seamounts = {{.x = 0, .y = 0, .radius_m = 100, .height_m = 44},
                               {.x = 5000, .y = 0, .radius_m = 100, .height_m = 55}};
  const Ocean ocean(settings);
  for (const double x : {0.0, 20.0, 50.0, 4950.0, 5000.0}) {
    const double bottom = ocean.waterDepth(x, 0);
    double above = ocean.temperature(0, x, 0, 1460 - 300);
    for (double z = 0.25; z <= bottom; z += 0.25) {
      const double here = ocean.temperature(z, x, 0, 1460 - 300);
      ASSERT_LE(here, above) << "folded over at " << z << " m of " << bottom;
      above = here;
      ASSERT_TRUE(std::isfinite(ocean.verticalCurrent(z, x, 0, 1000)));
    }
  }
  EXPECT_EQ(ocean.verticalCurrent(4, 5000, 0, 1000), 0);
  EXPECT_TRUE(std::isnan(ocean.isothermDepth(15.5, 5000, 0, 1000))) << "it lies under the bottom";
}

TEST(Ocean, HasAFrontAcrossItsBearing) {
  OceanSettings settings = twoLayers();
  settings.wave.amplitude_m = 0;
  settings.front = {
      .x = 700, .y = 0, .bearing_rad = std::numbers::pi / 2, .width_m = 80, .step_degC = -6};
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.temperature(14, 0, 0, 0), 15.5, 1e-6);
  EXPECT_NEAR(ocean.temperature(14, 700, 900, 0), 12.5, 1e-9) << "half the step on the front";
  EXPECT_NEAR(ocean.temperature(14, 780, 0, 0), 15.5 - 3 * (1 + std::tanh(1)), 1e-9);
  EXPECT_NEAR(ocean.temperature(60, 2000, 0, 0), 1, 1e-3);
  const double z = ocean.isothermDepth(12, 700, 0, 0);
  EXPECT_NEAR(ocean.temperature(z, 700, 0, 0), 12, 1e-9);
}

TEST(Ocean, CurrentIsStraightBetweenSurfaceAndBottom) {
  OceanSettings settings = twoLayers();
  settings.current = {0.1, 0};
  settings.bottom_current = {-0.06, 0.02};
  const Ocean ocean(settings);
  EXPECT_EQ(ocean.current(0, 0, 0).east, 0.1);
  EXPECT_NEAR(ocean.current(15, 0, 0).east, 0.06, 1e-12);
  EXPECT_NEAR(ocean.current(15, 0, 0).north, 0.005, 1e-12);
  EXPECT_NEAR(ocean.current(60, 0, 0).east, -0.06, 1e-12);
}

TEST(Ocean, HasPatchesOfChlorophyllOnABackground) {
  OceanSettings settings = twoLayers();
  EXPECT_TRUE(std::isnan(Ocean(settings).chlorophyll(5, 0, 0))) << "no fluorometer on board";
  settings.chlorophyll_ugpl = 0.4;
  settings.patches = {
      {.x = 600, .y = 100, .radius_m = 250, .depth_m = 12, .thickness_m = 5, .peak_ugpl = 8}};
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.chlorophyll(12, 600, 100), 8.4, 1e-12);
  EXPECT_NEAR(ocean.chlorophyll(12, 600, 350), 0.4 + 8 / std::numbers::e, 1e-12);
  EXPECT_NEAR(ocean.chlorophyll(17, 350, 100), 0.4 + 8 * std::exp(-2), 1e-12);
  EXPECT_NEAR(ocean.chlorophyll(12, -5000, 0), 0.4, 1e-12);
}

TEST(Ocean, OxygenFollowsTheThermocline) {
  OceanSettings settings = twoLayers();
  EXPECT_TRUE(std::isnan(Ocean(settings).oxygen(5, 0, 0, 0)));
  settings.surface_oxygen_uM = 260;
  settings.bottom_oxygen_uM = 170;
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.oxygen(14, 0, 0, 0), 215, 1e-9);
  EXPECT_NEAR(ocean.oxygen(0, 0, 0, 0), 260, 0.01);
  EXPECT_NEAR(ocean.oxygen(60, 0, 0, 0), 170, 0.01);
}

}  // namespace
}  // namespace glider::simulator
