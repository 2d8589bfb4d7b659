// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/scenario/scenario.h"

#include "platforms/load/load_platform.h"
#include "support/diagnostics/render.h"
#include "support/files.h"
#include "tests/unit/simulator/slocum_vehicle.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace glider::simulator {
namespace {

namespace fs = std::filesystem;

const std::string kHead = "name = \"x\"\nskeleton = \"x.mi\"\nduration_s = 100\n";
const std::string kStart = "[start]\nlatitude_deg = 39\nlongitude_deg = -73\n";

class ScenarioFile : public testing::Test {
 protected:
  ScenarioFile()
      : folder_(fs::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::create_directories(folder_);
    skeleton("behavior: surface\n b_arg: start_when(enum) 1\n");
  }
  ~ScenarioFile() override { fs::remove_all(folder_); }

  void skeleton(const std::string& text) {
    ASSERT_TRUE(support::writeFileAtomically(folder_ / "x.mi", text));
  }
  /// "" or the failure as "GLnnnn message".
  std::string load(const std::string& toml) {
    EXPECT_TRUE(support::writeFileAtomically(folder_ / "x.toml", toml));
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    auto result = loadScenario(folder_ / "x.toml", slocumPlatform(), sources, diagnostics);
    rendered_ = support::render(diagnostics, sources, false);
    if (!result) {
      return support::code(result.error().id) + " " + result.error().message;
    }
    scenario_ = std::move(*result);
    return "";
  }

  fs::path folder_;
  Scenario scenario_;
  std::string rendered_;
};

TEST_F(ScenarioFile, ReadsDefaultsAndValues) {
  EXPECT_EQ(load(kHead + kStart), "");  // accepts: GL5001 GL5120
  EXPECT_TRUE(std::isnan(scenario_.isotherm_degC));
  EXPECT_EQ(scenario_.vehicle.flight.hull_volume_m3, 65.0 / 1025) << "neutral in its water";
  EXPECT_EQ(scenario_.year, 2025);
  EXPECT_EQ(load(kHead + kStart + "year = 2029.5\n"), "");
  EXPECT_EQ(scenario_.year, 2029.5);
  EXPECT_EQ(
      load(kHead + "seed = 7\n" + kStart +
           "[ocean]\ndensity_kgm3 = 1020\n[ocean.wave]\namplitude_m = 3\n" +
           "[sensors]\ntemperature_degC = 0.5\n[[sensors.stale_water]]\nfrom_s = 10\nto_s = 20\n"),
      "");
  EXPECT_EQ(scenario_.seed, 7U);
  EXPECT_EQ(scenario_.vehicle.flight.hull_volume_m3, 65.0 / 1020);
  EXPECT_EQ(scenario_.ocean.wave.amplitude_m, 3);
  EXPECT_EQ(scenario_.sensors.ctd.stale_water.size(), 1U);
}

TEST_F(ScenarioFile, ReadsSwellAndCycles) {
  ASSERT_EQ(load(kHead + kStart +
                 "[ocean.swell]\namplitude_m = 0.8\nperiod_s = 11\nbearing_deg = 90\n"
                 "followed_share = 0.5\n"
                 "[vehicle.cycle]\nmean_s = 4.4\nspread_s = 0.2\nlong_share = 0.05\nlong_s = 14\n"),
            "");
  EXPECT_EQ(scenario_.ocean.swell.amplitude_m, 0.8);
  EXPECT_EQ(scenario_.ocean.swell.period_s, 11);
  EXPECT_NEAR(scenario_.ocean.swell.bearing_rad, 1.5708, 1e-4);
  EXPECT_EQ(scenario_.ocean.swell.followed_share, 0.5);
  EXPECT_EQ(scenario_.cycles.mean_s, 4.4);
  EXPECT_EQ(scenario_.cycles.spread_s, 0.2);
  EXPECT_EQ(scenario_.cycles.long_share, 0.05);
  EXPECT_EQ(scenario_.cycles.long_s, 14);
}

TEST_F(ScenarioFile, ReadsTheOceansTables) {
  ASSERT_EQ(load(kHead + kStart +
                 "[ocean]\nbottom_slope_m_per_km = 8\nbottom_slope_bearing_deg = 90\n"
                 "current_east_mps = 0.1\nbottom_current_north_mps = 0.2\n"
                 "surface_oxygen_uM = 260\nbottom_oxygen_uM = 170\n"
                 "surface_salinity = 30.5\nbottom_salinity = 34\n"
                 "[ocean.front]\nlatitude_deg = 39\nlongitude_deg = -72.99\nbearing_deg = 90\n"
                 "step_degC = -6\nstep_salinity = -1.5\n"
                 "[[ocean.patch]]\nlatitude_deg = 39.01\nlongitude_deg = -73\nradius_m = 300\n"
                 "depth_m = 12\nthickness_m = 5\npeak_ugpl = 8\n"
                 "[[ocean.seamount]]\nlatitude_deg = 39\nlongitude_deg = -73.01\n"
                 "radius_m = 200\nheight_m = 20\n"),
            "");
  const OceanSettings& o = scenario_.ocean;
  EXPECT_NEAR(o.bottom.slope, 0.008, 1e-15);
  EXPECT_NEAR(o.bottom.slope_bearing_rad, 1.5707963, 1e-7);
  EXPECT_EQ(o.bottom_current.east, 0.1) << "as at the surface, unless told otherwise";
  EXPECT_EQ(o.bottom_current.north, 0.2);
  EXPECT_EQ(scenario_.sensors.optode.surface_uM, 260);
  // At 39 N on the ellipsoid a degree of longitude has 86 627 m, one of latitude 111 015 m.
  EXPECT_NEAR(o.front.x, 866.3, 0.1);
  EXPECT_EQ(o.front.step_degC, -6);
  EXPECT_EQ(o.front.step_salinity, -1.5);
  EXPECT_EQ(o.surface_salinity, 30.5);
  EXPECT_EQ(o.bottom_salinity, 34);
  const FluorometerSettings& fluorometer = scenario_.sensors.fluorometer;
  ASSERT_EQ(fluorometer.patches.size(), 1U);
  EXPECT_NEAR(fluorometer.patches[0].y, 1110.1, 0.2);
  EXPECT_EQ(fluorometer.patches[0].peak_ugpl, 8);
  EXPECT_EQ(fluorometer.background_ugpl, 0) << "a patch puts a fluorometer on board";
  ASSERT_EQ(o.bottom.seamounts.size(), 1U);
  EXPECT_NEAR(o.bottom.seamounts[0].x, -866.3, 0.1);
}

TEST_F(ScenarioFile, ReadsTheBatteryAndTheSensorsTables) {
  ASSERT_EQ(
      load(kHead + kStart +
           "[vehicle.battery]\ncapacity_kJ = 400\nstart_V = 11\nsbc_W = 3.42\nsbc_asleep_W = 0.25\n"
           "[sensors.ctd]\nnoise_degC = 0.2\nnoise_Spm = 0.001\nrepeat_fraction = 0.1\nlate_s = 2\n"
           "non_monotonic_m = 0.7\nstale_climb = true\nstale_climb_count = 1\n"
           "[sensors.altimeter]\nrange_m = 40\ndropout = 0.1\n"),
      "");
  EXPECT_EQ(scenario_.vehicle.battery.power.capacity_kj, 400);
  EXPECT_EQ(scenario_.vehicle.battery.start_V, 11);
  EXPECT_EQ(scenario_.vehicle.battery.power.full_V, 14.4);
  EXPECT_EQ(scenario_.vehicle.battery.sbc_W, 3.42);
  EXPECT_EQ(scenario_.vehicle.battery.sbc_asleep_W, 0.25);
  const CtdSettings& ctd = scenario_.sensors.ctd;
  EXPECT_EQ(ctd.noise_degC, 0.2);
  EXPECT_EQ(ctd.noise_Spm, 0.001);
  EXPECT_EQ(ctd.repeat_fraction, 0.1);
  EXPECT_EQ(ctd.late_s, 2);
  EXPECT_EQ(ctd.non_monotonic_m, 0.7);
  EXPECT_TRUE(ctd.stale_climbs.on);
  EXPECT_EQ(ctd.stale_climbs.count, 1);
  EXPECT_EQ(scenario_.sensors.altimeter.range_m, 40);
  EXPECT_TRUE(scenario_.sensors.altimeter.given);
  // A pack whose full voltage is given starts full.
  ASSERT_EQ(load(kHead + kStart + "[vehicle.battery]\nfull_V = 16.8\n"), "");
  EXPECT_EQ(scenario_.vehicle.battery.start_V, 16.8);
}

TEST_F(ScenarioFile, RefusesWrongTablesWithTheirLine) {
  // The error is on line 9 of the file.
  const std::string place = "latitude_deg = 39\nlongitude_deg = -73\n";
  const std::pair<std::string, const char*> bad[] = {
      {"[ocean]\nbottom_slope_m_per_km = -1\nbottom_slope_bearing_deg = 3\n", ":9:"},
      {"[ocean]\nbottom_slope_m_per_km = 8\n", "needs `bottom_slope_bearing_deg`"},
      {"[ocean]\nbottom_slope_bearing_deg = 361\nbottom_slope_m_per_km = 8\n", ":9:"},
      {"[ocean]\nsurface_oxygen_uM = 200\n", "needs `bottom_oxygen_uM`"},
      {"[ocean]\nbottom_salinity = 35\n", "needs `surface_salinity`"},
      {"[ocean]\nsurface_salinity = 43\nbottom_salinity = 35\n", ":9:"},
      {"[ocean]\nsurface_salinity = 31\nbottom_salinity = 35\nconductivity_Spm = 4\n",
       "has no effect with `conductivity_Spm`"},
      {"[ocean]\nchlorophyll_ugpl = -1\n", ":9:"},
      {"[ocean]\nbottom_current_east_mps = 5\n", ":9:"},
      {"[ocean]\nfront = 5\n", "`front` of [ocean] must be a table"},
      {"[ocean.front]\ncolour = 5\n" + place + "step_degC = 1\nbearing_deg = 0\n", ":9:"},
      {"[ocean.front]\n" + place + "bearing_deg = 90\n", "[ocean.front] has no `step_degC`"},
      {"[ocean.front]\n" + place + "step_degC = 2\n", "[ocean.front] has no `bearing_deg`"},
      {"[ocean]\npatch = 5\n", "[[ocean.patch]] tables"},
      {"[ocean]\npatch = [1, 2]\n", "[[ocean.patch]] tables"},
      {"[[ocean.patch]]\nlatitude_deg = 95\n", ":9:"},
      {"[[ocean.patch]]\n" + place + "radius_m = 5\ndepth_m = 5\nthickness_m = 5\n",
       "has no `peak_ugpl`"},
      {"[[ocean.patch]]\nradius_m = 0\n" + place + "depth_m = 5\nthickness_m = 5\npeak_ugpl = 1\n",
       ":9:"},
      {"[[ocean.seamount]]\ndepth_m = 3\n" + place + "radius_m = 5\nheight_m = 5\n", ":9:"},
      {"[[ocean.seamount]]\nheight_m = -3\n" + place + "radius_m = 5\n", ":9:"},
      {"[vehicle]\nbattery = 12\n", "`battery` of [vehicle] must be a table"},
      {"[vehicle.battery]\nstart_V = 15\n", ":9:"},
      {"[vehicle.battery]\nempty_V = 15\n", "must be below `full_V`"},
      {"[vehicle.battery]\nvolts = 15\n", ":9:"},
      {"[sensors]\nctd = true\n", "`ctd` of [sensors] must be a table"},
      {"[sensors.ctd]\nrepeat_fraction = 1.5\n", ":9:"},
      {"[sensors.ctd]\nlate_s = nan\n", ":9:"},
      {"[sensors.ctd]\nstale_climb = 1\n", "must be true or false"},
      {"[sensors.ctd]\nstale_climb_s = 10\n", "has no effect without `stale_climb = true`"},
      {"[sensors]\ntemperature_degC = 1\n[sensors.ctd]\nnoise_degC = 1\n",
       "repeats `temperature_degC`"},
      {"[sensors.altimeter]\nrange_m = 500\n", ":9:"},
  };
  for (const auto& [text, why] : bad) {
    const std::string said = load(kHead + kStart + "\n" + text);
    EXPECT_TRUE(said.starts_with("GL5001")) << text << "\n-> " << said;
    EXPECT_NE(said.find(why), std::string::npos) << text << "\n-> " << said;
  }
}

TEST_F(ScenarioFile, ReadsFaults) {
  ASSERT_EQ(
      load(kHead + kStart +
           "[[faults.line]]\nline = \"sbc\"\nfrom_s = 10\nto_s = 20\nloss = 0.1\nbursts = 0.2\n"
           "burst_bytes = 5\n[[faults.line]]\nline = \"to_flight\"\nfrom_s = 3\ncut = true\n"
           "[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nvalue = nan\n"
           "[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nfrozen = true\n"
           "[[faults.power]]\nfrom_s = 5\n[[faults.port]]\nfrom_s = 5\nto_s = 6\n"
           "[[faults.stuck]]\nfrom_s = 7\n[[faults.modem]]\nfrom_s = 2\nto_s = "
           "90\n[[faults.science]]\nat_s = 8\n"
           "[[faults.clock]]\nat_s = 9\nby_s = -4\n[[faults.abort]]\nat_s = 30\n"),
      "");
  const Faults& faults = scenario_.faults;
  ASSERT_EQ(faults.lines.size(), 3U) << "both directions of one, one of the other";
  EXPECT_EQ(faults.lines[0].way, LineWay::ToSbc);
  EXPECT_EQ(faults.lines[1].way, LineWay::FromSbc);
  EXPECT_EQ(faults.lines[1].loss, 0.1);
  EXPECT_EQ(faults.lines[1].burst_bytes, 5);
  EXPECT_TRUE(faults.lines[2].cut);
  EXPECT_EQ(faults.lines[2].when.to_s, kForever);
  EXPECT_TRUE(std::isnan(faults.sensors[0].value));
  EXPECT_EQ(faults.sensors[1].kind, SensorFault::Kind::Frozen);
  EXPECT_EQ(faults.power[0].to_s, kForever);
  EXPECT_EQ(faults.port[0].to_s, 6);
  EXPECT_EQ(faults.science[0].to_s, 68) << "a minute unless told otherwise";
  EXPECT_EQ(faults.clock[0].by_s, -4);
  EXPECT_EQ(faults.first(), 1);
  ASSERT_EQ(faults.modem.size(), 1U);
  EXPECT_EQ(faults.modem[0].from_s, 2);
  EXPECT_EQ(faults.lastEnd(), 90);
}

TEST_F(ScenarioFile, ReadsSensorsThatAreOffAndThatLieNowAndThen) {
  const std::string ctd = "[[faults.sensor]]\nsensor = \"sci_water_pressure\"\nfrom_s = 1\n";
  ASSERT_EQ(load(kHead + kStart + ctd + "offset = 1.01\n" + ctd + "value = 3\nvalue_share = 0.5\n"),
            "");
  const auto& sensors = scenario_.faults.sensors;
  ASSERT_EQ(sensors.size(), 2U);
  EXPECT_EQ(sensors[0].kind, SensorFault::Kind::Offset);
  EXPECT_EQ(sensors[0].value, 1.01);
  EXPECT_EQ(sensors[1].kind, SensorFault::Kind::Value);
  EXPECT_EQ(sensors[1].share, 0.5);
}

TEST_F(ScenarioFile, ReadsSensorsThatDriftScaleAndJump) {
  const std::string depth = "[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\n";
  ASSERT_EQ(load(kHead + kStart + depth + "drift_per_s = -0.02\n" + depth + "scale = 0.5\n" +
                 depth + "jumps = 20\njumps_share = 0.1\n" + depth + "sways = 2\nperiod_s = 90\n" +
                 depth + "sways = 3\n"),
            "");
  const auto& sensors = scenario_.faults.sensors;
  ASSERT_EQ(sensors.size(), 5U);
  EXPECT_EQ(sensors[0].kind, SensorFault::Kind::Drift);
  EXPECT_EQ(sensors[0].value, -0.02);
  EXPECT_EQ(sensors[1].kind, SensorFault::Kind::Scale);
  EXPECT_EQ(sensors[1].value, 0.5);
  EXPECT_EQ(sensors[2].kind, SensorFault::Kind::Jumps);
  EXPECT_EQ(sensors[2].value, 20);
  EXPECT_EQ(sensors[2].share, 0.1);
  EXPECT_EQ(sensors[3].kind, SensorFault::Kind::Sways);
  EXPECT_EQ(sensors[3].value, 2);
  EXPECT_EQ(sensors[3].period_s, 90);
  EXPECT_EQ(sensors[4].period_s, 120);
}

TEST_F(ScenarioFile, ReadsRestartsCardsReplaysAndWhatIsLeftOver) {
  ASSERT_EQ(load(kHead + kStart +
                 "[[faults.line]]\nline = \"from_sbc\"\nfrom_s = 10\nreplayed = 0.3\n"
                 "[[faults.flight]]\nat_s = 20\n"
                 "[[faults.flight]]\nat_s = 200\ntakes_s = 4\nkeeps_array = true\n"
                 "[[faults.card]]\nat_s = 30\nflips = 12\n[[faults.card]]\nat_s = 31\ncut = 0.5\n"
                 "[[faults.card]]\nat_s = 32\nzeroed = 0.25\n"
                 "[[faults.leftover]]\nsession = 4\nsequence = 65535\n"),
            "");
  const Faults& faults = scenario_.faults;
  EXPECT_EQ(faults.lines.at(0).replayed, 0.3);
  ASSERT_EQ(faults.flight.size(), 2U);
  EXPECT_EQ(faults.flight[0].when.to_s, 80);
  EXPECT_FALSE(faults.flight[0].keeps_array);
  EXPECT_EQ(faults.flight[1].when.to_s, 204);
  EXPECT_TRUE(faults.flight[1].keeps_array);
  ASSERT_EQ(faults.card.size(), 3U);
  EXPECT_EQ(faults.card[0].kind, CardFault::Kind::Flips);
  EXPECT_EQ(faults.card[0].amount, 12);
  EXPECT_EQ(faults.card[1].kind, CardFault::Kind::Cut);
  EXPECT_EQ(faults.card[2].kind, CardFault::Kind::Zeroed);
  EXPECT_EQ(faults.card[2].amount, 0.25);
  ASSERT_EQ(faults.leftover.size(), 1U);
  EXPECT_EQ(faults.leftover[0].session, 4U);
  EXPECT_EQ(faults.leftover[0].sequence, 65535U);
  EXPECT_EQ(faults.leftover[0].depth_m, 20);
  EXPECT_EQ(faults.first(), 0);
  EXPECT_EQ(faults.lastEnd(), 204);
  Faults more;
  more.add(faults);
  EXPECT_EQ(more.card.size() + more.flight.size() + more.leftover.size(), 6U);
}

TEST_F(ScenarioFile, RefusesFaultsThatAreNone) {
  const std::pair<std::string, const char*> bad[] = {
      {"[faults]\nwind = 3\n", "`wind`"},
      {"[faults]\nline = 3\n", "[[faults.line]] tables"},
      {"[[faults.line]]\nline = \"up\"\nfrom_s = 1\ncut = true\n", "must be \"sbc\""},
      {"[[faults.line]]\nline = \"sbc\"\nfrom_s = 1\n", "no fault set"},
      {"[[faults.line]]\nline = \"sbc\"\nloss = 1\n", "no `from_s`"},
      {"[[faults.line]]\nline = \"sbc\"\nfrom_s = 1\nloss = 1.1\n", "between 0 and 1"},
      {"[[faults.power]]\nfrom_s = 10\nto_s = 10\n", "must be after `from_s`"},
      {"[[faults.power]]\nfrom_s = -1\n", "between 0 and"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\n", "needs one of"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nfrozen = true\nperiod_s = 9\n",
       "needs `sways` as well"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nsways = 1\nperiod_s = 0.5\n",
       "between 1 and"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nfrozen = true\nvalue = 3\n",
       "needs one of"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nfrozen = true\nscale = 3\n",
       "needs one of"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nscale = 3\ndrift_per_s = 1\n",
       "needs one of"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nscale = 3\njumps_share = 0.5\n",
       "needs `jumps`"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nscale = 3\nvalue_share = 0.5\n",
       "needs `value`"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nscale = 3\noffset = 1\n",
       "needs one of"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\njumps = -3\n", "between 0 and"},
      {"[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 1\nvalue = \"3\"\n", "must be a number"},
      {"[[faults.clock]]\nat_s = 1\n", "no `by_s`"},
      {"[[faults.science]]\nat_s = 1\ntakes_s = 0\n", "between 1 and"},
      {"[[faults.abort]]\nfrom_s = 1\n", "`from_s`"},
      {"[[faults.line]]\nline = \"sbc\"\nfrom_s = 1\nreplayed = 1.5\n", "between 0 and 1"},
      {"[[faults.card]]\nat_s = 1\n", "needs one of"},
      {"[[faults.card]]\nat_s = 1\ncut = 0.5\nflips = 2\n", "needs one of"},
      {"[[faults.card]]\nat_s = 1\ncut = 2\n", "between 0 and 1"},
      {"[[faults.flight]]\nat_s = 1\ntakes_s = 0\n", "between 1 and"},
      {"[[faults.flight]]\nfrom_s = 1\n", "`from_s`"},
      {"[[faults.leftover]]\nsession = 1\n", "no `sequence`"},
      {"[[faults.leftover]]\nsession = 1\nsequence = 70000\n", "between 1 and"},
  };
  for (const auto& [text, why] : bad) {
    const std::string said = load(kHead + kStart + "\n" + text);
    EXPECT_TRUE(said.starts_with("GL5001")) << text << "\n-> " << said;
    EXPECT_NE(said.find(why), std::string::npos) << text << "\n-> " << said;
  }
}

TEST_F(ScenarioFile, RefusesWhatIsNotRight) {
  const std::string bad[] = {
      "name = ",
      kHead,
      kStart,
      kHead + "colour = 1\n" + kStart,
      kHead + "seed = -1\n" + kStart,
      kHead + "ocean = 3\n" + kStart,
      "name = \"x\"\nskeleton = \"x.mi\"\nduration_s = 0\n" + kStart,
      "name = \"x\"\nskeleton = \"x.mi\"\nduration_s = \"long\"\n" + kStart,
      kHead + "[start]\nlatitude_deg = 100\nlongitude_deg = 0\n",
      kHead + kStart + "year = 2024.9\n",
      kHead + kStart + "year = 2030.1\n",
      kHead + kStart + "[ocean]\nwater_depth_m = 10\n",
      kHead + kStart + "[ocean]\nsurface_temp_degC = nan\n",
      kHead + kStart + "[ocean]\nwave = 2\n",
      kHead + kStart + "[ocean.wave]\namplitude_m = 15\n",
      kHead + kStart + "[ocean.swell]\nperiod_s = 60\n",
      kHead + kStart + "[ocean.swell]\nfollowed_share = 2\n",
      kHead + kStart + "[vehicle.cycle]\nlong_share = -1\n",
      kHead + kStart + "[vehicle]\ndrag = -1\n",
      kHead + kStart + "[sensors]\nctd_dropout = 2\n",
      kHead + kStart + "[sensors]\nstale_water = 3\n",
      kHead + kStart + "[[sensors.stale_water]]\nfrom_s = 20\nto_s = 10\n",
  };
  for (const std::string& text : bad) {
    EXPECT_TRUE(load(text).starts_with("GL5001")) << text << "\n-> " << load(text);
  }
}

TEST_F(ScenarioFile, NamesAMissingFileAndASkeletonWithErrors) {
  fs::remove(folder_ / "x.mi");
  EXPECT_TRUE(load(kHead + kStart).starts_with("GL9001"));
  skeleton("behavior: surfac\n");
  EXPECT_TRUE(load(kHead + kStart).starts_with("GL5120"));
  EXPECT_NE(
      rendered_.find("x.mi:1:11: error: behaviour `surfac` is not supported by the simulator"),
      std::string::npos)
      << rendered_;
}

TEST(Scenarios, ShippedOnesLoadWithoutAMessage) {
  const fs::path folder = fs::path(GLIDER_SOURCE_DIR) / "scenarios";
  for (const char* name : {"bloom", "default", "figure5", "figure6", "first_deployment", "front",
                           "layered", "low_battery", "shelf_slope"}) {
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    const auto scenario = loadScenario(folder / (std::string(name) + ".toml"), slocumPlatform(),
                                       sources, diagnostics);
    ASSERT_TRUE(scenario) << scenario.error().message
                          << support::render(diagnostics, sources, false);
    EXPECT_EQ(scenario->name, name);
    EXPECT_EQ(support::render(diagnostics, sources, false), "");
  }
}

}  // namespace
}  // namespace glider::simulator
