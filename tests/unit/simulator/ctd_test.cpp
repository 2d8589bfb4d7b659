// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/ctd/ctd.h"

#include "runtime/abi/glider_abi.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::simulator {
namespace {

/// The temperature of water that is one degree colder with every metre.
double gradientTemperature(double depth_m) {
  return 30 - depth_m;
}

/// That water, and saltier with every metre.
Ctd::Water gradient(double depth_m) {
  return {gradientTemperature(depth_m), 30 + 0.1 * depth_m};
}

Ctd::Column uniform(double temperature_degC) {
  return [temperature_degC](double) { return Ctd::Water{temperature_degC, 35}; };
}

/// The temperature read, NaN when there is none.
double temperature(Ctd& ctd, const Ctd::Column& water, double depth_m, double now_s) {
  const auto reading = ctd.read(water, depth_m, now_s);
  return reading ? reading->temperature_degC : NAN;
}

CtdSettings silent() {
  return {.noise_degC = 0, .noise_Spm = 0};
}

TEST(Ctd, ReadsTheWaterAroundIt) {
  Ctd ctd(1, silent());
  const auto reading = ctd.read(gradient, 12, 0);
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->temperature_degC, 18);
  EXPECT_EQ(reading->depth_m, 12);
  // 12 m below the surface are 12 dbar: 1.2e5 Pa.
  EXPECT_NEAR(gliderSalinity(reading->conductivity, 18, 1.2e5), 31.2, 1e-9);
}

TEST(Ctd, MeasuresTheConductivityThatAScenarioGivesTheWater) {
  CtdSettings settings = silent();
  settings.conductivity = 4;
  Ctd ctd(1, settings);
  EXPECT_EQ(ctd.read(gradient, 12, 0)->conductivity, 4);
}

TEST(Ctd, MeasuresTheConductivityWithNoise) {
  CtdSettings settings = silent();
  settings.noise_Spm = 0.001;
  Ctd ctd(1, settings);
  const double clean = Ctd(1, silent()).read(gradient, 12, 0)->conductivity;
  constexpr int kCount = 2000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double off = ctd.read(gradient, 12, i)->conductivity - clean;
    sum += off;
    squares += off * off;
  }
  EXPECT_NEAR(sum / kCount, 0, 1e-4);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.001, 1e-4);
}

TEST(Ctd, KeepsTheSaltOfStaleWater) {
  CtdSettings settings = silent();
  settings.stale_water = {{10, 20}};
  Ctd ctd(1, settings);
  ctd.read(gradient, 5, 9);
  const auto held = ctd.read(gradient, 15, 15);
  EXPECT_NEAR(gliderSalinity(held->conductivity, held->temperature_degC, 1.5e5), 30.5, 1e-9);
  const auto fresh = ctd.read(gradient, 15, 20);
  EXPECT_NEAR(gliderSalinity(fresh->conductivity, fresh->temperature_degC, 1.5e5), 31.5, 1e-9);
}

TEST(Ctd, KnowsTheSalinityUnderASwell) {
  Ctd ctd(1, silent());
  const auto reading = ctd.read(gradient, 12, 0, 1.5);
  EXPECT_EQ(reading->depth_m, 13.5);
  EXPECT_NEAR(gliderSalinity(reading->conductivity, 18, 1.35e5), 31.2, 1e-9);
}

TEST(Ctd, KeepsStaleWater) {
  CtdSettings settings = silent();
  settings.stale_water = {{10, 20}};
  Ctd ctd(1, settings);
  EXPECT_EQ(temperature(ctd, uniform(18), 5, 9), 18);
  EXPECT_EQ(temperature(ctd, uniform(12), 5, 10), 18) << "the old water is still in the duct";
  EXPECT_EQ(temperature(ctd, uniform(9), 5, 19), 18);
  EXPECT_EQ(temperature(ctd, uniform(9), 5, 20), 9);
}

TEST(Ctd, LosesReadings) {
  CtdSettings settings = silent();
  settings.dropout = 0.5;
  Ctd ctd(1, settings);
  int lost = 0;
  for (int i = 0; i < 1000; ++i) {
    lost += ctd.read(gradient, 5, i) ? 0 : 1;
  }
  EXPECT_NEAR(lost, 500, 60);
}

TEST(Ctd, IsLate) {
  CtdSettings settings = silent();
  settings.late_s = 3;
  Ctd ctd(1, settings);
  EXPECT_FALSE(ctd.read(gradient, 10, 0));
  EXPECT_FALSE(ctd.read(gradient, 11, 1));
  EXPECT_FALSE(ctd.read(gradient, 12, 2));
  const auto reading = ctd.read(gradient, 13, 3);
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->temperature_degC, 20) << "what was read at 0 s";
  EXPECT_EQ(reading->depth_m, 10);
  EXPECT_EQ(temperature(ctd, gradient, 14, 4), 19);
}

TEST(Ctd, RepeatsReadings) {
  CtdSettings settings = silent();
  settings.repeat_fraction = 0.25;
  Ctd ctd(1, settings);
  double before = NAN;
  int repeated = 0;
  for (int i = 0; i < 1000; ++i) {
    const double read = temperature(ctd, gradient, i * 0.01, i);
    repeated += read == before ? 1 : 0;
    EXPECT_TRUE(read == before || read == gradientTemperature(i * 0.01)) << i;
    before = read;
  }
  EXPECT_NEAR(repeated, 250, 50);
}

TEST(Ctd, SeesWaterFromAboveAndBelow) {
  CtdSettings settings = silent();
  settings.non_monotonic_m = 0.8;
  Ctd ctd(1, settings), same(1, settings), other_seed(2, settings);
  double sum = 0, squares = 0;
  bool differs = false;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    const double off = temperature(ctd, gradient, 10, i) - 20;
    EXPECT_EQ(off, temperature(same, gradient, 10, i) - 20);
    differs = differs || off != temperature(other_seed, gradient, 10, i) - 20;
    sum += off;
    squares += off * off;
  }
  EXPECT_TRUE(differs);
  EXPECT_NEAR(sum / kCount, 0, 0.05);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.8, 0.05);
  EXPECT_EQ(temperature(
                ctd, [](double z) { return Ctd::Water{z < 0 ? -99.0 : 20.0, 35}; }, 0, kCount),
            20)
      << "there is no water above the surface";
}

/// A saw-tooth of 0.2 m/s between 5 and 25 m: down for 100 s, up for 100 s.
double sawtooth(double t) {
  const double phase = std::fmod(t, 200);
  return phase < 100 ? 5 + 0.2 * phase : 25 - 0.2 * (phase - 100);
}

/// The temperatures that the CTD gives on the saw-tooth, one a second.
std::vector<double> sawtoothReadings(const CtdSettings& settings, int seconds) {
  Ctd ctd(1, settings);
  std::vector<double> readings;
  for (int t = 0; t < seconds; ++t) {
    readings.push_back(temperature(ctd, gradient, sawtooth(t), t));
  }
  return readings;
}

TEST(Ctd, KeepsStaleWaterOnClimbs) {
  CtdSettings settings = silent();
  settings.stale_climbs = {.on = true, .frozen_s = 50, .flush_s = 0};
  const auto readings = sawtoothReadings(settings, 400);
  // The climb from 100 s is seen once it is more than half a metre up, at 103 s.
  EXPECT_NEAR(readings[102], gradientTemperature(sawtooth(102)), 1e-12);
  for (const size_t t : {103U, 120U, 152U}) {
    EXPECT_NEAR(readings[t], gradientTemperature(sawtooth(102)), 1e-12) << t;
  }
  EXPECT_NEAR(readings[153], gradientTemperature(sawtooth(153)), 1e-12) << "flushed";
  EXPECT_NEAR(readings[250], gradientTemperature(sawtooth(250)), 1e-12) << "dives are not stale";
  EXPECT_NEAR(readings[340], gradientTemperature(sawtooth(302)), 1e-12) << "each climb is";
}

TEST(Ctd, RenewsItsWaterSlowlyAfterAStaleStart) {
  CtdSettings settings = silent();
  settings.stale_climbs = {.on = true, .frozen_s = 0, .flush_s = 20};
  const auto readings = sawtoothReadings(settings, 260);
  // Behind a steady rise of 0.2 degC/s a first-order lag of 20 s is 4 degC late, less a sample.
  EXPECT_NEAR(gradientTemperature(sawtooth(195)) - readings[195], 0.2 * 20, 0.2);
  EXPECT_NEAR(readings[210], gradientTemperature(sawtooth(210)), 1e-12);
}

TEST(Ctd, KeepsStaleWaterOnTheClimbsThatAreMeant) {
  CtdSettings settings = silent();
  settings.stale_climbs = {.on = true, .frozen_s = 1000, .flush_s = 0, .after_s = 250, .count = 1};
  const auto readings = sawtoothReadings(settings, 800);
  EXPECT_NEAR(readings[150], gradientTemperature(sawtooth(150)), 1e-12) << "too early";
  EXPECT_NEAR(readings[390], gradientTemperature(sawtooth(302)), 1e-12)
      << "to the end of the climb";
  EXPECT_NEAR(readings[410], gradientTemperature(sawtooth(410)), 1e-12)
      << "the dive after it is not stale";
  EXPECT_NEAR(readings[550], gradientTemperature(sawtooth(550)), 1e-12) << "one climb only";
}

}  // namespace
}  // namespace glider::simulator
