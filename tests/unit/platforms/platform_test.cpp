// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/load_platform.h"
#include "support/diagnostics/diagnostic.h"
#include "tests/slocum.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

namespace glider::platforms {
namespace {

constexpr const char* kHead =
    "name = \"p\"\ndescription = \"d\"\n[envelope]\ngreatest_depth_m = 1.0\nsteepest_pitch_rad = "
    "1.0\nshallowest_pitch_rad = 0.1\nvertical_rate_m_s = 0.4\ninflection_overshoot_m = "
    "5.0\ndrift_m_s = 0.5\npump_cc = 233.0\ncycle_s = "
    "4.0\n[world]\nstart_depth_m = 3.0\nsurface_depth_m = 2.0\nslowest_climb_m_s = 0.05\nturn_s = "
    "120.0\ndepth_error_m = 0.5\ntick_gap_s = 12.0\n"
    "through_water_m_s = 0.6\nsteering_error_m = 200.0\nsurface_drift_m_s = 0.8\n";
constexpr const char* kSensor =
    "[[sensor]]\nname = \"a\"\nunit = \"m\"\nlowest = 0.0\nhighest = 1.0\nstale_after_s = "
    "1.0\ncomputer = \"flight\"\n"
    "bytes = 4\nnoise = 0.1\nwhat = \"w\"\n";

support::Result<Platform> loadText(const std::string& text) {
  const tests::TemporaryFolder folder;
  return loadPlatform(folder.write("p.toml", text));
}

TEST(Platform, TheSlocumLoadsAndItsNumbersAreTheHeaders) {
  const auto platform = loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  ASSERT_TRUE(platform) << platform.error().message;
  EXPECT_EQ(platform->sensors.size(), size_t{GLIDER_SENSOR_COUNT});
  EXPECT_EQ(platform->find("temp"), platform->find("sci_water_temp"));
  EXPECT_EQ(platform->find("m_depth")->id, GLIDER_M_DEPTH);
  EXPECT_EQ(platform->find("pressure")->to_si, 1e5);
  EXPECT_EQ(platform->find("nothing"), nullptr);
}

// accepts: GL5001
TEST(Platform, ErrorsInTheFileAreReportedWithTheirLine) {
  ASSERT_TRUE(loadText(std::string(kHead) + kSensor));
  const std::pair<std::string, std::string> bad[] = {
      {"", "has no `name`"},
      {"name = 3\ndescription = \"d\"\n", "must be a string"},
      {kHead, "[[sensor]]"},
      {std::string(kHead) + "sensor = 5\n", "unknown key"},
      {std::string(kHead).substr(0, std::string(kHead).find("[world]")) + kSensor, "start_depth_m"},
      {std::string(kHead) + kSensor + kSensor, "taken"},
      {std::string(kHead) + kSensor + "colour = 1\n", "`colour`"},
      {std::string("name = "), "p.toml:1"},
  };
  for (const auto& [text, expected] : bad) {
    const auto platform = loadText(text);
    ASSERT_FALSE(platform) << text;
    EXPECT_EQ(support::code(platform.error().id), "GL5001");
    EXPECT_NE(platform.error().message.find(expected), std::string::npos)
        << platform.error().message;
  }
}

TEST(Platform, ValuesOutsideTheirMeaningAreRefused) {
  auto with = [&](const std::string& from, const std::string& to) {
    std::string text = std::string(kHead) + kSensor;
    text.replace(text.rfind(from), from.size(), to);
    return loadText(text);
  };
  EXPECT_FALSE(with("unit = \"m\"", "unit = \"furlong\""));
  EXPECT_FALSE(with("highest = 1.0", "highest = 0.0"));
  EXPECT_FALSE(with("highest = 1.0", "highest = nan"));
  EXPECT_FALSE(with("stale_after_s = 1.0", "stale_after_s = -1.0"));
  EXPECT_FALSE(with("bytes = 4", "bytes = 3"));
  EXPECT_FALSE(with("drift_m_s = 0.5", "drift_m_s = 0.0"));
  // A program waits for a reading of `depth_error_m` less, of 0.25 m or more.
  EXPECT_TRUE(with("start_depth_m = 3.0", "start_depth_m = 0.75"));
  EXPECT_FALSE(with("start_depth_m = 3.0", "start_depth_m = 0.7"));
  EXPECT_FALSE(with("vertical_rate_m_s = 0.4", "vertical_rate_m_s = -1.0"));
  EXPECT_FALSE(with("noise = 0.1", "noise = -0.1"));
  EXPECT_FALSE(with("tick_gap_s = 12.0", "tick_gap_s = 0.0"));
  EXPECT_FALSE(with("turn_s = 120.0", ""));
  EXPECT_FALSE(with("shallowest_pitch_rad = 0.1", "shallowest_pitch_rad = 0.0"));
  EXPECT_FALSE(with("through_water_m_s = 0.6", "through_water_m_s = 0.0"));
  EXPECT_FALSE(with("steering_error_m = 200.0", ""));
  EXPECT_FALSE(with("surface_drift_m_s = 0.8", "surface_drift_m_s = -0.8"));
  EXPECT_FALSE(with("surface_drift_m_s = 0.8", ""));
  EXPECT_TRUE(with("surface_drift_m_s = 0.8", "surface_drift_m_s = 0.8\nline_lag_s = 8.0"));
  EXPECT_FALSE(with("surface_drift_m_s = 0.8", "surface_drift_m_s = 0.8\nline_lag_s = 8.1"));
  EXPECT_FALSE(with("\"flight\"", "\"kitchen\""));
}

TEST(Platform, AVehicleMayHaveNoFin) {
  const auto with = [](const std::string& line) {
    std::string text = std::string(kHead) + kSensor;
    text.insert(text.find("cycle_s"), line);
    return loadText(text);
  };
  EXPECT_EQ(with("")->envelope.fin_rad, 0);
  EXPECT_EQ(with("")->envelope.battery_in, 0);
  EXPECT_EQ(with("battery_in = 0.5\n")->envelope.battery_in, 0.5);
  EXPECT_FALSE(with("battery_in = -0.1\n"));
  EXPECT_FALSE(with("battery_in = nan\n"));
  EXPECT_EQ(with("fin_rad = 0.3\n")->envelope.fin_rad, 0.3);
  for (const char* bad : {"-0.1", "1.6", "nan", "inf", "\"wide\""}) {
    EXPECT_FALSE(with(std::string("fin_rad = ") + bad + "\n")) << bad;
  }
}

/// The simulator turns a vehicle by its fin.
TEST(Platform, ASimulatedVehicleHasAFin) {
  std::string text = tests::slurp(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  const tests::TemporaryFolder folder;
  ASSERT_TRUE(loadPlatform(folder.write("slocum.toml", text)));
  text.erase(text.find("fin_rad ="), std::string("fin_rad = 0.45\n").size());
  const auto platform = loadPlatform(folder.write("slocum.toml", text));
  ASSERT_FALSE(platform);
  EXPECT_NE(platform.error().message.find("turns the vehicle by its fin"), std::string::npos)
      << platform.error().message;
}

// accepts: GL5001
TEST(Platform, ItsNameIsThatOfItsFileAndAWordOfTheLanguage) {
  const tests::TemporaryFolder folder;
  const auto named = [&](const std::string& file, const std::string& name) {
    const std::string rest = std::string(kHead).substr(std::string(kHead).find('\n'));
    const auto platform =
        loadPlatform(folder.write(file + ".toml", "name = \"" + name + "\"" + rest + kSensor));
    return platform ? "" : platform.error().message;
  };
  EXPECT_EQ(named("p", "p"), "");
  EXPECT_EQ(named("deep_2", "deep_2"), "");
  EXPECT_NE(named("p", "q").find("that of the file"), std::string::npos);
  EXPECT_NE(named("my-glider", "my-glider").find("letters, digits"), std::string::npos);
  EXPECT_NE(named("2_deep", "2_deep").find("begin with a letter"), std::string::npos);
}

/// What is said of the Slocum's file with `to` in place of `from`; empty: nothing.
std::string slocumWith(const std::string& from, const std::string& to) {
  static const std::string slocum = tests::slurp(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  std::string text = slocum;
  text.replace(text.find("name = \"slocum\""), 15, "name = \"p\"");
  text.replace(text.find(from), from.size(), to);
  const auto platform = loadText(text);
  return platform ? "" : platform.error().message;
}

// accepts: GL5001
TEST(Platform, WhatMovesItIsGivenAsAWhole) {
  EXPECT_EQ(slocumWith("", ""), "");
  EXPECT_NE(slocumWith("[power]", "[might]").find("might"), std::string::npos);
  EXPECT_NE(loadText(std::string(kHead) + "[power]\nfull_V = 5\n" + kSensor)
                .error()
                .message.find("without [motion]"),
            std::string::npos);
  EXPECT_NE(slocumWith("\nmass_kg = 65.0", "").find("mass_kg"), std::string::npos);
  EXPECT_NE(slocumWith("\nfull_V = 14.4", "").find("full_V"), std::string::npos);
  EXPECT_NE(slocumWith("hull_lift = 3.8", "hull_lift = -3.8").find("above 0"), std::string::npos);
  EXPECT_NE(slocumWith("empty_V = 10.0", "empty_V = 14.4").find("below `full_V`"),
            std::string::npos);
  EXPECT_NE(slocumWith("resistance_ohm = 0.47", "resistance_ohm = -1.0").find("below 0"),
            std::string::npos);
}

// accepts: GL5001
TEST(Platform, TheOvershootOfSteepDivesIsGivenWithItsPitch) {
  EXPECT_NE(slocumWith("\nsteep_overshoot_m = 6.5", "").find("steep_overshoot_m"),
            std::string::npos);
  EXPECT_NE(slocumWith("\novershoot_pitch_rad = 0.6284", "").find("overshoot_pitch_rad"),
            std::string::npos);
  EXPECT_NE(slocumWith("steep_overshoot_m = 6.5", "steep_overshoot_m = 4.9").find("not be below"),
            std::string::npos);
  EXPECT_EQ(slocumWith("\nsteep_overshoot_m = 6.5\novershoot_pitch_rad = 0.6284", ""), "");
}

/// The rows of the power table: each bad row is one error that names it.
TEST(Platform, ThePowerTableIsChecked) {
  const std::pair<std::pair<const char*, const char*>, const char*> errors[] = {
      {{"W = 0.8", "W = -0.8"}, "below 0"},
      {{"W = 0.8", "J = 0.8"}, "`W`"},
      {{"W = 0.8\nspread = 0.6", "W = 0.8\nspread = 1.2"}, "a share of the number"},
      {{"when = \"always\"", "when = \"ever\""}, "must be one of \"always\", \"surface\""},
      {{"device = \"hotel\"", "device = \"SBC\""}, "its power is elsewhere"},
      {{"device = \"hotel\"", "device = \"\""}, "must not be empty"},
      {{"when = \"surfacing\"\nJ", "when = \"surface\"\nW"}, "already has a row for \"surface\""},
      {{"when = \"pump_in\"", "when = \"fin_moves\""}, "`W`"},
      {{"sensors = [\"sci_oxy4_oxygen\"]", "sensors = [\"sci_oxy5_oxygen\"]"},
       "must name sensors of the vehicle, and `sci_oxy5_oxygen` is none"},
      {{"J_per_cc_m = 0.018\n", ""}, "J_per_cc_m"}};
  for (const auto& [change, why] : errors) {
    EXPECT_NE(slocumWith(change.first, change.second).find(why), std::string::npos)
        << change.second << ": " << slocumWith(change.first, change.second);
  }
  EXPECT_NE(slocumWith("when = \"pump_in\"\nJ_per_cc = 0.40", "when = \"always\"\nW = 0.40")
                .find("must have a row with `when = \"pump_in\"`"),
            std::string::npos);
}

TEST(Platform, WhatBoundsOfEnergyAssumeIsWholeOrNotThere) {
  EXPECT_NE(slocumWith("\nglide_m_s = 0.53", "").find("glide_m_s"), std::string::npos);
  EXPECT_NE(slocumWith("hover_pump_cc_s = 2.5", "hover_pump_cc_s = 0.0").find("above 0"),
            std::string::npos);
  EXPECT_NE(slocumWith("dive_start_s = 120.0", "dive_start_s = 120.0\ndives = 1").find("dives"),
            std::string::npos);
  EXPECT_NE(slocumWith("[power.bounds]", "[power.limits]").find("limits"), std::string::npos);
}

TEST(Platform, HowOftenAndHowExactlyASensorIsReported) {
  const auto with = [](const std::string& stale, const std::string& more) {
    std::string text = std::string(kHead) + kSensor;
    text.replace(text.rfind("stale_after_s = 1.0"), 19, "stale_after_s = " + stale);
    return loadText(text + more);
  };
  const auto usual = with("1.0", "");
  ASSERT_TRUE(usual);
  EXPECT_EQ(usual->sensors[0].every_s, 4) << "in each cycle";
  EXPECT_EQ(usual->sensors[0].dead_band, 0) << "exactly";
  const auto sparse = with("60.0", "every_s = 60.0\ndead_band = 0.25\n");
  ASSERT_TRUE(sparse) << sparse.error().message;
  EXPECT_EQ(sparse->sensors[0].every_s, 60);
  EXPECT_EQ(sparse->sensors[0].dead_band, 0.25);
  EXPECT_FALSE(with("60.0", "every_s = 64.0\n")) << "stale before the next one comes";
  EXPECT_FALSE(with("60.0", "every_s = 6.0\n")) << "between two cycles";
  EXPECT_FALSE(with("60.0", "every_s = 0.0\n"));
  EXPECT_FALSE(with("2000.0", "every_s = 1024.0\n")) << "more cycles than a byte counts";
  EXPECT_FALSE(with("60.0", "dead_band = -0.1\n"));
  EXPECT_FALSE(with("60.0", "dead_band = nan\n"));
  EXPECT_FALSE(with("60.0", "dead_band = 2.0\n")) << "wider than the range";
}

}  // namespace
}  // namespace glider::platforms
