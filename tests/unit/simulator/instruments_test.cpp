// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/glider_abi.h"
#include "simulator/sensors/provided.h"
#include "simulator/sensors/sensor_list.h"
#include "simulator/simulator.h"
#include "support/files.h"
#include "tests/unit/simulator/slocum_vehicle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

/// The instruments of the list: each against its formula, and what all of them promise.
namespace glider::simulator {
namespace {

OceanSettings twoLayers() {
  OceanSettings settings;
  settings.thermocline_depth_m = 14;
  settings.thermocline_thickness_m = 2.5;
  settings.bottom.depth_m = 60;
  return settings;
}

/// The first reading of `instrument` at such a place, at 0 s.
double readAt(Instrument& instrument, const Ocean& ocean, double z, double x = 0, double y = 0) {
  std::vector<double> readings(instrument.sensors().size(), NAN);
  instrument.sample({0, z, x, y, ocean}, readings);
  return readings.at(0);
}

FluorometerSettings twoPatches() {
  FluorometerSettings settings;
  settings.noise_ugpl = 0;
  settings.background_ugpl = 0.4;
  settings.patches = {
      {.x = 600, .y = 100, .radius_m = 250, .depth_m = 12, .thickness_m = 5, .peak_ugpl = 8},
      {.x = -50, .y = 20, .radius_m = 60, .depth_m = 20, .thickness_m = 7, .peak_ugpl = 3}};
  return settings;
}

TEST(Fluorometer, ReadsPatchesOfChlorophyllOnABackground) {
  const Ocean ocean(twoLayers());
  Fluorometer fluorometer(1, twoPatches());
  EXPECT_NEAR(readAt(fluorometer, ocean, 12, 600, 100), 8.4, 1e-12);
  EXPECT_NEAR(readAt(fluorometer, ocean, 12, 600, 350), 0.4 + 8 / std::numbers::e, 1e-12);
  EXPECT_NEAR(readAt(fluorometer, ocean, 17, 350, 100), 0.4 + 8 * std::exp(-2), 1e-12);
  EXPECT_NEAR(readAt(fluorometer, ocean, 12, -5000, 0), 0.4, 1e-12);
}

/// Against the formula written a second time.
TEST(Fluorometer, PatchesAddUp) {
  const FluorometerSettings settings = twoPatches();
  for (const double x : {-60.0, 0.0, 222.0, 555.0}) {
    for (const double y : {-50.0, 10.0, 95.0}) {
      for (const double z : {0.0, 11.0, 14.0, 31.0}) {
        const double green = 0.4 +
                             8 * std::exp(-(std::pow(x - 600, 2) + std::pow(y - 100, 2)) / 62500 -
                                          std::pow((z - 12) / 5, 2)) +
                             3 * std::exp(-(std::pow(x + 50, 2) + std::pow(y - 20, 2)) / 3600 -
                                          std::pow((z - 20) / 7, 2));
        ASSERT_NEAR(settings.chlorophyll(z, x, y), green, 1e-9);
      }
    }
  }
}

TEST(Optode, FollowsTheThermocline) {
  const Ocean ocean(twoLayers());
  Optode optode(1, {.noise_uM = 0, .surface_uM = 260, .bottom_uM = 170});
  EXPECT_NEAR(readAt(optode, ocean, 14), 215, 1e-9);
  EXPECT_NEAR(readAt(optode, ocean, 0), 260, 0.01);
  EXPECT_NEAR(readAt(optode, ocean, 60), 170, 0.01);
  EXPECT_NEAR(readAt(optode, ocean, 15), 170 + 45 * (1 - std::tanh(1 / 2.5)), 1e-9);
}

TEST(Ctd, GivesNothingForAReadingThatItLoses) {
  const Ocean ocean(twoLayers());
  Ctd broken(1, {.dropout = 1}), good(1, {.noise_degC = 0, .noise_Spm = 0});
  std::vector<double> readings(3, NAN);
  broken.sample({0, 14, 0, 0, ocean}, readings);
  for (const double reading : readings) {
    EXPECT_TRUE(std::isnan(reading));
  }
  good.sample({0, 14, 0, 0, ocean}, readings);
  EXPECT_NEAR(readings[0], 15, 1e-12);
  EXPECT_NEAR(gliderSalinity(readings[1], readings[0], readings[2] * 1e5), 32.25, 1e-9)
      << "half way between the layers";
  EXPECT_EQ(readings[2], 1.4);
}

TEST(Instruments, AreOnBoardIfTheScenarioHasWhatTheyRead) {
  Scenario scenario;
  const auto missing = sensorsNotCarried(scenario);
  ASSERT_EQ(missing.size(), 2U);
  EXPECT_EQ(missing[0].name, "sci_flbbcd_chlor_units");
  EXPECT_EQ(missing[0].setting, "`chlorophyll_ugpl` in [ocean]");
  EXPECT_EQ(missing[1].name, "sci_oxy4_oxygen");
  EXPECT_EQ(missing[1].setting, "`surface_oxygen_uM` and `bottom_oxygen_uM` in [ocean]");
  scenario.sensors.fluorometer.background_ugpl = 0;
  scenario.sensors.optode.surface_uM = scenario.sensors.optode.bottom_uM = 200;
  EXPECT_TRUE(sensorsNotCarried(scenario).empty());
}

TEST(Instruments, SetSensorsOfTheScienceComputerAndEachItsOwn) {
  std::set<std::string_view> seen;
  for (const auto& instrument : makeInstruments(1, {})) {
    EXPECT_EQ(instrument->carried(), instrument->setting().empty())
        << "without settings there is what each vehicle has, and no more";
    EXPECT_FALSE(instrument->sensors().empty());
    for (const InstrumentSensor& sensor : instrument->sensors()) {
      EXPECT_TRUE(seen.insert(sensor.name).second) << sensor.name;
      EXPECT_TRUE(isProvided(sensor.name));
      const platforms::PlatformSensor* of_vehicle = slocumPlatform().find(sensor.name);
      ASSERT_NE(of_vehicle, nullptr) << sensor.name;
      EXPECT_EQ(of_vehicle->computer, platforms::Computer::Science) << sensor.name;
    }
  }
}

/// A sensor that reads the key of another would take its setting.
TEST(Sensors, HaveKeysOfTheirOwnWhichTheReadmeNames) {
  const auto readme = support::readFile(GLIDER_SOURCE_DIR "/scenarios/README.md");
  ASSERT_TRUE(readme);
  for (const std::string table : {"sensors", "ocean"}) {
    std::set<std::string_view> seen;
    for (const std::string_view key : sensorKeys(table)) {
      EXPECT_TRUE(seen.insert(key).second) << key;
      const std::string name(key);
      EXPECT_TRUE(readme->contains("`" + name + "`") ||
                  readme->contains("[" + table + "." + name + "]"))
          << "[" << table << "] " << name;
    }
    EXPECT_FALSE(seen.empty());
  }
}

TEST(Noise, OfTheFirstSensorsHasTheNumbersThatItAlwaysHad) {
  const std::string_view numbered[] = {"m_depth",
                                       "m_pitch",
                                       "m_heading",
                                       "m_altitude",
                                       "gps",
                                       "sci_water_temp",
                                       "ctd dropout",
                                       "ctd depth",
                                       "ctd repeat",
                                       "altimeter dropout",
                                       "sci_flbbcd_chlor_units",
                                       "sci_oxy4_oxygen"};
  uint32_t stream = 0;
  for (const std::string_view source : numbered) {
    EXPECT_EQ(Noise(7, source).normal(1), Noise(7, stream).normal(1)) << source;
    ++stream;
  }
}

TEST(Noise, OfEachOtherSourceIsItsOwn) {
  std::set<double> first;
  for (const uint32_t stream : {0U, 1U, 5U, 12U, 16U, 0x84222325U}) {
    EXPECT_TRUE(first.insert(Noise(7, stream).uniform()).second);
  }
  for (const std::string_view source : {"", "a", "b", "ab", "ba", "sci_suna_nitrate"}) {
    EXPECT_TRUE(first.insert(Noise(7, source).uniform()).second) << source;
    EXPECT_EQ(Noise(7, source).uniform(), Noise(7, source).uniform());
    EXPECT_NE(Noise(7, source).uniform(), Noise(8, source).uniform());
  }
}

}  // namespace
}  // namespace glider::simulator
