// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How long the way home takes, and after which silence it begins.

#include "vehicles/slocum/rules/way_home.h"

#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/vehicle.h"
#include "tests/support/command.h"
#include "vehicles/slocum/mission_files/load.h"
#include "vehicles/slocum/rules/vehicle_file.h"

#include <gtest/gtest.h>

namespace glider::slocum::rules {
namespace {

// A real vehicle's cycle may take as long as `tick_gap_s`; `cycle_s` is the usual one.
TEST(WayHome, IsTheSilenceTwoOfTheLongestCyclesTheTurnAndTheClimb) {
  platforms::Platform platform;
  platform.envelope.cycle_s = 4;
  platform.world.tick_gap_s = 15;
  platform.world.turn_s = 100;
  platform.world.slowest_climb_m_s = 0.05;
  const vehicles::WayHome home = wayHomeFrom(20, platform, {30, "here"});
  EXPECT_EQ(home.depth_m, 20);
  EXPECT_DOUBLE_EQ(home.surface_s, 30 + 30 + 100 + 400);
  EXPECT_DOUBLE_EQ(wayHomeFrom(0, platform, {30, "here"}).surface_s, 160);
}

TEST(UsualSilence, IsThatOfHookbeh) {
  EXPECT_EQ(usualSilence().seconds, 24);
  EXPECT_EQ(usualSilence().source, "assuming silence_secs 24; see --mi");
}

/// Of a mission that naps the file must say more: as much as it needs, with the time to wake.
TEST(UsualSilence, OfASleepingSbcIsLonger) {
  ir::Mission naps;
  EXPECT_EQ(usualSilence(naps).seconds, 24);
  naps.nap_s = 240;
  EXPECT_EQ(usualSilence(naps).seconds, 24 + 280);
  EXPECT_EQ(usualSilence(naps).source, "assuming silence_secs 24 and nap_secs 280; see --mi");
}

class SilenceOf : public ::testing::Test {
 protected:
  [[nodiscard]] support::Result<VehicleFile> of(const std::string& value) const {
    return read(
        folder_
            .write("a.mi", "behavior: surface\nbehavior: hookbeh\n    b_arg: silence_secs(s) " +
                               value + "\n")
            .string());
  }
  static support::Result<VehicleFile> read(const std::string& path) {
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    const auto file = loadMission(path, sources, diagnostics, [](auto&&...) {});
    return file ? vehicleFileOf(*file, path)
                : support::Result<VehicleFile>(std::unexpected(file.error()));
  }
  const tests::TemporaryFolder folder_;
};

TEST_F(SilenceOf, IsThatOfTheVehiclesMissionFile) {
  const auto silence = of("300.5");
  ASSERT_TRUE(silence);
  EXPECT_EQ(silence->silence.seconds, 300.5);
  EXPECT_EQ(silence->silence.source, "silence_secs 300.5 from a.mi");
}

TEST_F(SilenceOf, IsFromAboveNothingToTenMinutes) {
  EXPECT_TRUE(of("600"));
  EXPECT_TRUE(of("0.5"));
  for (const char* wrong : {"601", "3600", "0", "-5"}) {
    const auto silence = of(wrong);
    ASSERT_FALSE(silence) << wrong;
    EXPECT_EQ(silence.error().id, support::diagnostics::skeletonErrors);
  }
}

TEST_F(SilenceOf, CountsTheNapsOfAMissionThatHasThem) {
  const auto file = of("30\n    b_arg: nap_secs(s) 280");
  ASSERT_TRUE(file);
  ir::Mission mission;
  EXPECT_EQ(silenceOf(*file, mission).seconds, 30);
  mission.nap_s = 240;
  EXPECT_EQ(silenceOf(*file, mission).seconds, 310);
  EXPECT_EQ(silenceOf(*file, mission).source, "silence_secs 30 and nap_secs 280 from a.mi");
  for (const char* wrong : {"7201", "-1", "1000003"}) {
    EXPECT_FALSE(of(std::string("30\n    b_arg: nap_secs(s) ") + wrong)) << wrong;
  }
}

/// hookbeh releases control if the SBC sleeps for longer than the beats on its behalf count.
TEST_F(SilenceOf, IsTooShortForLongerNaps) {
  const auto said = [&](const std::string& nap_secs, std::optional<double> nap_s) {
    ir::Mission mission;
    mission.nap_s = nap_s;
    support::DiagnosticEngine diagnostics;
    checkNaps(mission, *of("30\n    b_arg: nap_secs(s) " + nap_secs), {}, diagnostics);
    const auto all = diagnostics.sorted();
    return all.empty() ? std::string() : all.front().message;
  };
  EXPECT_EQ(said("0", std::nullopt), "");
  EXPECT_EQ(said("280", 240), "");
  EXPECT_EQ(said("249", 240),
            "the SBC does not get control, or loses it: the mission lets it sleep for up to 4 min "
            "0 s, and hookbeh releases control after 4 min 9 s (nap_secs 249 in a.mi)");
  EXPECT_EQ(said("0", 240),
            "the SBC does not get control, or loses it: the mission lets it sleep for up to 4 min "
            "0 s, and hookbeh releases control in its first nap (nap_secs 0 in a.mi)");
}

TEST_F(SilenceOf, MayBeInAnArgumentFile) {
  (void)folder_.write(
      "hookbe03.ma",
      "behavior_name=hookbeh\n<start:b_arg>\nb_arg: silence_secs(s) 60\n<end:b_arg>\n");
  const auto silence = read(
      folder_.write("a.mi", "behavior: hookbeh\n    b_arg: args_from_file(enum) 3\n").string());
  ASSERT_TRUE(silence);
  EXPECT_EQ(silence->silence.seconds, 60);
}

TEST_F(SilenceOf, WithoutAHookbehIsNone) {
  const auto silence = read(folder_.write("a.mi", "behavior: surface\n").string());
  ASSERT_FALSE(silence);
  EXPECT_EQ(silence.error().id, support::diagnostics::skeletonErrors);
  EXPECT_EQ(read((folder_.path() / "none.mi").string()).error().id,
            support::diagnostics::cannotRead);
}

}  // namespace
}  // namespace glider::slocum::rules
