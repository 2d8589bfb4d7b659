// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ocean/ocean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

OceanSettings layeredSettings() {
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
  const Ocean ocean(layeredSettings());
  EXPECT_NEAR(ocean.temperature(0, 0, 0, 0), 24, 0.01);
  EXPECT_NEAR(ocean.temperature(60, 0, 0, 0), 7, 0.01);
  EXPECT_NEAR(ocean.temperature(14, 0, 0, 0), 15.5, 1e-12);
  for (double z = 0; z < 60; z += 0.5) {
    EXPECT_GE(ocean.temperature(z, 0, 0, 500), ocean.temperature(z + 0.5, 0, 0, 500));
  }
}

TEST(Ocean, IsDenserBelowWhereThereIsAPycnocline) {
  OceanSettings settings = layeredSettings();
  EXPECT_EQ(Ocean(settings).density(0, 0, 0, 0), 1025);
  EXPECT_EQ(Ocean(settings).density(50, 0, 0, 0), 1025 * compression(50e4)) << "without a step";
  settings.density_step = 4;
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.density(0, 0, 0, 0), 1023, 0.01);
  EXPECT_NEAR(ocean.density(60, 0, 0, 0), 1027 * compression(60e4), 0.01);
  EXPECT_NEAR(ocean.density(14, 0, 0, 0), 1025 * compression(14e4), 1e-9);
  EXPECT_LT(ocean.density(16, 0, 0, 260 + 300), ocean.density(16, 0, 0, 0)) << "the wave lowers it";
}

TEST(Ocean, IsSaltierBelowAsItIsColder) {
  OceanSettings settings = layeredSettings();
  settings.surface_salinity = 31;
  settings.bottom_salinity = 34;
  const Ocean ocean(settings);
  for (const double t : {0.0, 560.0}) {  // without a wave and with one
    for (double z = 0; z < 60; z += 2.5) {
      const double share = (ocean.temperature(z, 0, 0, t) - 7) / (24 - 7);
      EXPECT_NEAR(ocean.salinity(z, 0, 0, t), 34 - 3 * share, 1e-9) << z;
    }
  }
}

// Published: UNESCO technical papers in marine science 44 (1983), its check values and formula for
// a salinity of 35. TEOS-10 differs by 0.004 kg/m3 from it.
TEST(Ocean, IsCompressedByTheWaterAbove) {
  struct Row {
    double surface, at_1000_dbar;  ///< kg/m3
  };
  for (const Row& row : {Row{1027.675, 1032.258}, Row{1026.952, 1031.430}}) {  // 5 and 10 degC
    EXPECT_NEAR(row.surface * compression(1e7), row.at_1000_dbar, 0.12);
  }
  EXPECT_NEAR(1026.952 * compression(1e7), 1031.430, 0.005) << "10 degC";
  EXPECT_NEAR(1027.675 * compression(1e8), 1069.489, 1) << "5 degC, 10000 dbar, far beyond gliders";
  EXPECT_EQ(compression(0), 1);
  // About 4.5 kg/m3 in 1000 m.
  EXPECT_NEAR(Ocean(layeredSettings()).density(1000, 0, 0, 0) - 1025, 4.5, 0.1);
}

TEST(Ocean, HasOneWaveThatIsNowhereElse) {
  const Ocean ocean(layeredSettings());
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
  OceanSettings settings = layeredSettings();
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
  const Ocean ocean(layeredSettings());
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
  OceanSettings settings = layeredSettings();
  settings.bottom.wave_height_m = 5;
  settings.bottom.wave_length_m = 100;
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.waterDepth(25, 0), 55, 1e-9);
  EXPECT_NEAR(ocean.waterDepth(0, 75), 65, 1e-9);
}

TEST(Ocean, BottomSlopesTowardsItsBearing) {
  OceanSettings settings = layeredSettings();
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
  OceanSettings settings = layeredSettings();
  settings.bottom.seamounts = {{.x = 600, .y = -100, .radius_m = 200, .height_m = 20}};
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.waterDepth(600, -100), 40, 1e-9);
  EXPECT_NEAR(ocean.waterDepth(600, 100), 60 - 20 / std::numbers::e, 1e-9);
  EXPECT_NEAR(ocean.waterDepth(-2000, 0), 60, 1e-9);
}

TEST(Ocean, WaveEndsWhereTheBottomRisesToTheThermocline) {
  OceanSettings settings = layeredSettings();
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
  OceanSettings settings = layeredSettings();
  settings.wave.amplitude_m = 0;
  settings.front = {
      .x = 700, .y = 0, .bearing_rad = std::numbers::pi / 2, .width_m = 80, .step_degC = -6};
  const Ocean ocean(settings);
  EXPECT_NEAR(ocean.temperature(14, 0, 0, 0), 15.5, 1e-6);
  EXPECT_NEAR(ocean.temperature(14, 700, 900, 0), 12.5, 1e-9) << "half the step on the front";
  EXPECT_NEAR(ocean.temperature(14, 780, 0, 0), 15.5 - 3 * (1 + std::tanh(1)), 1e-9);
  EXPECT_NEAR(ocean.temperature(60, 2000, 0, 0), 1, 1e-3);
  EXPECT_EQ(ocean.salinity(14, 2000, 0, 0), ocean.salinity(14, 0, 0, 0));
  const double z = ocean.isothermDepth(12, 700, 0, 0);
  EXPECT_NEAR(ocean.temperature(z, 700, 0, 0), 12, 1e-9);
}

TEST(Ocean, IsSaltierBeyondAFrontOfSalt) {
  OceanSettings settings = layeredSettings();
  settings.front = {
      .x = 700, .y = 0, .bearing_rad = std::numbers::pi / 2, .width_m = 80, .step_salinity = 1.5};
  const Ocean ocean(settings);
  const double here = ocean.salinity(30, 0, 0, 0);
  EXPECT_NEAR(ocean.salinity(30, 700, 900, 0), here + 0.75, 1e-6);
  EXPECT_NEAR(ocean.salinity(30, 2000, 0, 0), here + 1.5, 1e-6);
  EXPECT_EQ(ocean.temperature(30, 2000, 0, 0), ocean.temperature(30, 0, 0, 0));
  settings.front.step_salinity = -20;
  settings.surface_salinity = settings.bottom_salinity = 5;
  EXPECT_EQ(Ocean(settings).salinity(30, 2000, 0, 0), 0) << "fresh, not less";
}

TEST(Ocean, CurrentIsStraightBetweenSurfaceAndBottom) {
  OceanSettings settings = layeredSettings();
  settings.current = {0.1, 0};
  settings.bottom_current = {-0.06, 0.02};
  const Ocean ocean(settings);
  EXPECT_EQ(ocean.current(0, 0, 0).east, 0.1);
  EXPECT_NEAR(ocean.current(15, 0, 0).east, 0.06, 1e-12);
  EXPECT_NEAR(ocean.current(15, 0, 0).north, 0.005, 1e-12);
  EXPECT_NEAR(ocean.current(60, 0, 0).east, -0.06, 1e-12);
}

/// Every field at once, against the formulas written a second time.
TEST(Ocean, FieldsAreThoseOfTheFormulas) {
  constexpr double kTurn = 2 * std::numbers::pi;
  OceanSettings s = layeredSettings();
  s.wave = {
      .amplitude_m = 4, .period_s = 900, .wavelength_m = 700, .phase_rad = 0.4, .start_s = 60};
  s.current = {0.2, -0.1};
  s.bottom_current = {-0.05, 0.3};
  s.front = {.x = 100, .y = -200, .bearing_rad = 0.7, .width_m = 150, .step_degC = -5};
  s.bottom.slope = 0.004;
  s.bottom.slope_bearing_rad = 2.1;
  s.bottom.seamounts = {{.x = 300, .y = 50, .radius_m = 120, .height_m = 12}};
  const Ocean ocean(s);
  for (const double x : {-310.0, 0.0, 222.0, 333.0}) {
    for (const double y : {-150.0, 10.0, 95.0}) {
      for (const double t : {0.0, 333.0, 1234.5}) {
        const double water = 60 + 0.004 * (x * std::sin(2.1) + y * std::cos(2.1)) -
                             12 * std::exp(-((x - 300) * (x - 300) + (y - 50) * (y - 50)) / 14400);
        ASSERT_NEAR(ocean.waterDepth(x, y), water, 1e-9);
        const double angle = kTurn * ((t - 60) / 900 - x / 700) + 0.4;
        const double beyond = (x - 100) * std::sin(0.7) + (y + 200) * std::cos(0.7);
        const double front = -5 * (1 + std::tanh(beyond / 150)) / 2;
        for (const double z : {0.0, 3.0, 14.0, 15.0, 31.0}) {
          const double shape = z <= 14 ? z / 14 : (water - z) / (water - 14);
          const double upper = (1 - std::tanh((z - 14 - 4 * std::sin(angle) * shape) / 2.5)) / 2;
          ASSERT_NEAR(ocean.temperature(z, x, y, t), 7 + 17 * upper + front, 1e-9) << z;
          ASSERT_NEAR(ocean.upperShare(z, x, y, t), upper, 1e-11);
          ASSERT_NEAR(ocean.verticalCurrent(z, x, y, t), -4 * std::cos(angle) * kTurn / 900 * shape,
                      1e-12);
          const Planar current = ocean.current(z, x, y);
          ASSERT_NEAR(current.east, 0.2 - 0.25 * z / water, 1e-12);
          ASSERT_NEAR(current.north, -0.1 + 0.4 * z / water, 1e-12);
        }
      }
    }
  }
}

}  // namespace
}  // namespace glider::simulator
