// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/scenario/scenario.h"

#include "simulator/flight/skeleton.h"
#include "slocum/mission_files/read.h"
#include "support/diagnostics/render.h"
#include "support/files.h"

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
    auto result = loadScenario(folder_ / "x.toml", sources, diagnostics);
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
  EXPECT_EQ(
      load(kHead + "seed = 7\n" + kStart +
           "[ocean]\ndensity_kgm3 = 1020\n[ocean.wave]\namplitude_m = 3\n" +
           "[sensors]\ntemperature_degC = 0.5\n[[sensors.stale_water]]\nfrom_s = 10\nto_s = 20\n"),
      "");
  EXPECT_EQ(scenario_.seed, 7U);
  EXPECT_EQ(scenario_.vehicle.flight.hull_volume_m3, 65.0 / 1020);
  EXPECT_EQ(scenario_.ocean.wave.amplitude_m, 3);
  EXPECT_EQ(scenario_.sensors.stale_water.size(), 1U);
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
      kHead + kStart + "[ocean]\nwater_depth_m = 10\n",
      kHead + kStart + "[ocean]\nsurface_temp_degC = nan\n",
      kHead + kStart + "[ocean]\nwave = 2\n",
      kHead + kStart + "[ocean.wave]\namplitude_m = 15\n",
      kHead + kStart + "[vehicle]\ndrag = -1\n",
      kHead + kStart + "[sensors]\nctd_dropout = 2\n",
      kHead + kStart + "[sensors]\nstale_water = 3\n",
      kHead + kStart + "[[sensors.stale_water]]\nfrom_s = 20\nto_s = 10\n",
  };
  for (const std::string& text : bad) {
    EXPECT_TRUE(load(text).starts_with("GL5001")) << text << "\n-> " << load(text);
  }
}

TEST_F(ScenarioFile, NamesAMissingFileAndASkeletonWithMistakes) {
  fs::remove(folder_ / "x.mi");
  EXPECT_TRUE(load(kHead + kStart).starts_with("GL9001"));
  skeleton("behavior: warp_drive\n");
  EXPECT_TRUE(load(kHead + kStart).starts_with("GL5120"));
  EXPECT_NE(rendered_.find("x.mi:1:11: error: the simulator cannot fly behaviour `warp_drive`"),
            std::string::npos)
      << rendered_;
}

/// The codes that checking `mission` gives.
std::string check(const std::string& mission) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const uint32_t file = sources.add("test.mi", mission);
  const auto read = slocum::readMission(sources, file, diagnostics);
  if (read) {
    checkSkeleton(*read, {file, 0, 0}, diagnostics);
  }
  std::string out;
  for (const auto& diagnostic : diagnostics.sorted()) {
    out += (out.empty() ? "" : " ") + support::code(diagnostic.id);
  }
  return out;
}

TEST(Skeleton, RefusesWhatTheSimulatorCannotFly) {
  EXPECT_EQ(check("behavior: warp_drive\n"), "GL5103");
  EXPECT_EQ(check("behavior: yo\n b_arg: start_when(enum) 15\n"), "GL5107");
  EXPECT_EQ(check("behavior: yo\n b_arg: d_pitch_value(X) -26\n"), "GL5107");
  EXPECT_EQ(check("behavior: hookbeh\n b_arg: silence_secs(s) 1\n"), "GL5107");
  EXPECT_EQ(check("behavior: hookbeh\nbehavior: hookbeh\n"), "GL5105");
  EXPECT_EQ(check(""), "GL5108");
  // accepts: GL5103 GL5107 GL5108
  EXPECT_EQ(check("behavior: yo\n b_arg: start_when(enum) 2\n b_arg: d_pitch_value(X) -0.4538\n"),
            "");
}

TEST(Skeleton, WarnsOfWhatHasNoEffect) {
  EXPECT_EQ(check("behavior: yo\nbehavior: sample\n"), "GL5110");
  EXPECT_EQ(check("sensor: u_use_current_correction(nodim) 1\nbehavior: yo\n"), "GL5111");
  EXPECT_EQ(check("behavior: yo\n"), "");  // accepts: GL5110 GL5111
}

TEST(Scenarios, ShippedOnesLoadWithoutAWord) {
  const fs::path folder = fs::path(GLIDER_SOURCE_DIR) / "scenarios";
  for (const char* name : {"default", "figure5", "layered"}) {
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    const auto scenario =
        loadScenario(folder / (std::string(name) + ".toml"), sources, diagnostics);
    ASSERT_TRUE(scenario) << scenario.error().message
                          << support::render(diagnostics, sources, false);
    EXPECT_EQ(scenario->name, name);
    EXPECT_EQ(support::render(diagnostics, sources, false), "");
  }
}

}  // namespace
}  // namespace glider::simulator
