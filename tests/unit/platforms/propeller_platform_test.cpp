// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/load_platform.h"
#include "support/diagnostics/diagnostic.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <set>
#include <string>

/// The platform files of vehicles with a propeller.
namespace glider::platforms {
namespace {

using testing::HasSubstr;

std::string fileOf(const std::string& name) {
  return std::string(GLIDER_SOURCE_DIR "/platforms/") + name + ".toml";
}

/// What the loader says of `name`'s file with `from` replaced by `to`; empty if nothing.
std::string refusal(const std::string& name, const std::string& from, const std::string& to) {
  std::string text = tests::slurp(fileOf(name));
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const tests::TemporaryFolder folder;
  const auto platform = loadPlatform(folder.write(name + ".toml", text));
  if (!platform) {
    EXPECT_EQ(support::code(platform.error().id), "GL5001");
  }
  return platform ? "" : platform.error().message;
}

class PropellerPlatform : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Vehicles, PropellerPlatform, ::testing::Values("lauv", "remus100"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(PropellerPlatform, Loads) {
  const auto platform = loadPlatform(fileOf(GetParam()));
  ASSERT_TRUE(platform) << platform.error().message;
  ASSERT_TRUE(platform->motion && platform->motion->propelled);
  EXPECT_EQ(platform->motion->model, "propeller");
  EXPECT_EQ(platform->envelope.pump_cc, 0);
  EXPECT_EQ(platform->envelope.battery_in, 0);
  EXPECT_EQ(platform->envelope.fin_rad, 0);
  EXPECT_EQ(platform->power.propeller.rpm.size(), platform->power.propeller.watt.size());
}

/// The language's names of what a Slocum has too: a mission for one reads the same in the other.
TEST_P(PropellerPlatform, HasTheNamesOfTheLanguage) {
  const auto platform = loadPlatform(fileOf(GetParam()));
  const auto slocum = loadPlatform(fileOf("slocum"));
  ASSERT_TRUE(platform && slocum);
  for (const char* name :
       {"depth", "altitude", "pitch", "roll", "heading", "lat", "lon", "speed", "temp", "cond"}) {
    const PlatformSensor *here = platform->find(name), *there = slocum->find(name);
    ASSERT_NE(here, nullptr) << name;
    EXPECT_EQ(here->dimension, there->dimension) << name;
    EXPECT_EQ(here->kind, there->kind) << name;
    EXPECT_EQ(here->to_si, there->to_si) << name;
    EXPECT_FALSE(here->magnetic) << "these vehicles report true headings";
  }
  EXPECT_NE(platform->find("salinity"), nullptr);
}

// accepts: GL5001
TEST(PropellerPlatforms, KeysOfAnotherModelAreRefused) {
  EXPECT_THAT(refusal("lauv", "[motion]\n", "[motion]\npump_rate_cc_s = 3.0\n"),
              HasSubstr("unknown key `pump_rate_cc_s`"));
  EXPECT_THAT(refusal("lauv", "[envelope]\n", "[envelope]\npump_cc = 3.0\n"),
              HasSubstr("unknown key `pump_cc`"));
  EXPECT_THAT(refusal("lauv", "[motion.hull]\n", "[motion.flight]\ndrag = 1.0\n[motion.hull]\n"),
              HasSubstr("unknown key `flight`"));
  EXPECT_THAT(refusal("slocum", "[power]\n", "[power]\npropeller_W = [0.0]\n"),
              HasSubstr("unknown key `propeller_W`"));
  EXPECT_THAT(
      refusal("slocum", "[motion.flight]\n", "[motion.fins]\nlag_s = 1.0\n[motion.flight]\n"),
      HasSubstr("unknown key `fins`"));
  EXPECT_THAT(refusal("slocum", "pump_cc = 233.0\n", ""), HasSubstr("no `pump_cc`"));
  EXPECT_THAT(refusal("slocum", "pump_cc = 233.0", "pump_cc = 0.0"),
              HasSubstr("`pump_cc` of [envelope] must be above 0"));
  EXPECT_THAT(refusal("slocum", "model = \"glider\"", "model = \"propeller\""),
              HasSubstr("unknown key"));
}

TEST(PropellerPlatforms, NumbersOutsideTheirMeaningAreRefused) {
  const std::pair<std::string, std::string> bad[] = {
      {"mass_kg = 24.0", "mass_kg = 0.0"},
      {"mass_kg = 24.0\n", ""},
      {"mass_kg = 24.0", "mass_kg = nan"},
      {"creep_s_m = 0.0", "creep_s_m = -1.0"},
      {"positive_buoyancy_kg = 0.2", "positive_buoyancy_kg = -0.2"},
      {"turn_damping_Nm_s = 9.7", "turn_damping_Nm_s = 0.0"},
      {"rudder_rad = 0.5236", "rudder_rad = 1.6"},
      {"stern_plane_rad = 0.5236", "stern_plane_rad = 1.6"},
      {"greatest_thrust_N = 12.0", "greatest_thrust_N = 12.0\nwings = 2.0"},
      {"[motion.vertical]", "[motion.sideways]"},
      {"drift_m_s = 0.5", "drift_m_s = 0.5\nfin_rad = 0.6"},
  };
  for (const auto& [from, to] : bad) {
    EXPECT_NE(refusal("lauv", from, to), "") << from << " -> " << to;
  }
  EXPECT_EQ(refusal("lauv", "drift_m_s = 0.5", "drift_m_s = 0.5\nfin_rad = 0.5"), "");
  EXPECT_EQ(refusal("lauv", "side_moment_N_s2_m = 9.0", "side_moment_N_s2_m = -9.0"), "")
      << "fins may restore more than the moment of Munk";
}

// accepts: GL5001
TEST(PropellerPlatforms, ThePowerTableIsWholeAndReachesTheGreatestTurns) {
  const std::string rpm = "propeller_rpm = [0.0, 500.0, 1000.0, 1700.0]";
  const std::string watt = "propeller_W = [0.0, 30.0, 50.0, 80.0]";
  for (const char* bad : {"[0.0, 500.0, 1000.0, 1600.0]", "[1.0, 500.0, 1000.0, 1700.0]",
                          "[0.0, 500.0, 500.0, 1700.0]", "[0.0, 1000.0, 500.0, 1700.0]"}) {
    EXPECT_THAT(refusal("lauv", rpm, std::string("propeller_rpm = ") + bad),
                HasSubstr("must increase from 0 to `greatest_rpm` (1700) or more"))
        << bad;
  }
  EXPECT_THAT(refusal("lauv", watt, "propeller_W = [0.0, 30.0, 50.0]"),
              HasSubstr("a number that is not below 0 for each of `propeller_rpm`"));
  EXPECT_THAT(refusal("lauv", watt, "propeller_W = [0.0, 30.0, -50.0, 80.0]"),
              HasSubstr("for each"));
  EXPECT_THAT(refusal("lauv", watt, "propeller_W = [0.0, \"much\", 50.0, 80.0]"),
              HasSubstr("must be a list of finite numbers"));
  EXPECT_THAT(refusal("lauv", watt, "propeller_W = 80.0"), HasSubstr("list"));
  EXPECT_THAT(refusal("lauv", watt, ""), HasSubstr("no `propeller_W`"));
}

}  // namespace
}  // namespace glider::platforms
