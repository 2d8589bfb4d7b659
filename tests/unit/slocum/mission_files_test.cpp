// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/diagnostics/render.h"
#include "support/files.h"
#include "vehicles/slocum/mission_files/argument_files.h"
#include "vehicles/slocum/mission_files/behaviour_catalogue.h"
#include "vehicles/slocum/mission_files/read.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace glider::slocum {
namespace {

namespace fs = std::filesystem;

/// What reading a text as a mission (.mi) or argument file (.ma) gives.
struct Reading {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  std::optional<MissionFile> mission;
  std::optional<ArgumentFile> arguments;

  [[nodiscard]] std::string codes() const {
    std::string out;
    for (const auto& diagnostic : diagnostics.sorted()) {
      out += (out.empty() ? "" : " ") + support::code(diagnostic.id);
    }
    return out;
  }
  [[nodiscard]] std::string text() const { return support::render(diagnostics, sources, false); }
};

Reading mission(std::string text) {
  Reading out;
  out.mission =
      readMission(out.sources, out.sources.add("test.mi", std::move(text)), out.diagnostics);
  if (out.mission) {
    for (const BehaviourBlock& block : out.mission->behaviours) {
      checkArguments(block, out.diagnostics);
    }
  }
  return out;
}

Reading arguments(std::string text) {
  Reading out;
  out.arguments =
      readArguments(out.sources, out.sources.add("test.ma", std::move(text)), out.diagnostics);
  return out;
}

TEST(MissionFile, ReadsSensorsBehavioursCommentsAndWindowsLines) {
  const Reading r = mission(
      "# a comment\r\nSENSOR: u_use_current_correction(nodim) 1 # on\r\n\r\n"
      "behavior: Yo\r\n\tb_arg: D_Target_Depth(m)   30\r\n b_arg:start_when ( enum ) +2\r\n"
      "behavior: surface\ninstalled ctd41cp 1\n");
  ASSERT_TRUE(r.mission) << r.text();
  ASSERT_EQ(r.mission->behaviours.size(), 2U);
  EXPECT_EQ(r.mission->behaviours[0].name, "yo");
  EXPECT_EQ(r.mission->behaviours[0].value("d_target_depth"), 30);
  EXPECT_EQ(r.mission->behaviours[0].value("start_when"), 2);
  EXPECT_EQ(r.mission->behaviours[0].value("c_target_depth"), 3) << "the default";
  EXPECT_EQ(r.mission->sensors.at(0).name, "u_use_current_correction");
  EXPECT_EQ(r.mission->setup.at(0).words.size(), 3U);
  EXPECT_EQ(r.sources.place(0, r.mission->behaviours[0].arguments[1].name_range.begin).line, 6U);
  EXPECT_EQ(r.codes(), "");
}

TEST(MissionFile, PointsAtEachError) {
  EXPECT_EQ(mission("behaviour: yo\n").codes(), "GL5100");
  EXPECT_EQ(mission("behavior: yo yo\n").codes(), "GL5100");
  EXPECT_EQ(mission("behavior:\n b_arg: x(s) 1\n").codes(), "GL5100");
  EXPECT_EQ(mission("behavior: yo\n b_arg: d_target_depth 3\n").codes(), "GL5100");
  EXPECT_EQ(mission("behavior: yo\n b_arg: d_target_depth(m\n").codes(), "GL5100");
  EXPECT_EQ(mission("behavior: yo\n b_arg: d_target_depth(m)\n").codes(), "GL5100");
  EXPECT_EQ(mission("behavior: yo\n b_arg: d_target_depth(m) 3 4\n").codes(), "GL5100");
  EXPECT_EQ(mission("b_arg: d_target_depth(m) 3\n").codes(), "GL5101");
  EXPECT_EQ(mission("behavior: yo\n b_arg: d_target_depth(m) 3m\n").codes(), "GL5102");
  EXPECT_EQ(mission("behavior: yo\n b_arg: d_target_depth(m) nan\n").codes(), "GL5102");
  EXPECT_EQ(mission("behavior: yo\n b_arg: d_target_depth(m) 1e999\n").codes(), "GL5102");
  EXPECT_EQ(mission("behavior: yo\n b_arg: d_target_dept(m) 3\n").codes(), "GL5104");
  EXPECT_EQ(missionParameter(999999), std::nullopt);
  EXPECT_EQ(missionParameter(1000000), 0);
  EXPECT_EQ(missionParameter(1000025), 25);
  EXPECT_EQ(missionParameter(1000026), std::nullopt);
  EXPECT_EQ(mission("behavior: set_heading\n b_arg: use_heading(bool) 1\n").codes(), "GL5106");
  EXPECT_EQ(mission("behavior: set_heading\n").codes(), "") << "a bank to its limit, by default";
  // accepts: GL5100 GL5101 GL5102 GL5104 GL5105 GL5106
  EXPECT_EQ(mission("behavior: set_heading\n b_arg: heading_value(X) 1.5\n"
                    "behavior: yo\n b_arg: d_target_depth(m) 3\n b_arg: c_target_depth(m) 3\n")
                .codes(),
            "");
}

TEST(MissionFile, OfAnArgumentGivenTwiceTheLastCounts) {
  const Reading r = mission(
      "sensor: u_use_current_correction(nodim) 1\nsensor: U_USE_CURRENT_CORRECTION(nodim) 0\n"
      "behavior: yo\n b_arg: d_target_depth(m) 3\n b_arg: c_target_depth(m) 2\n"
      " b_arg: D_TARGET_DEPTH(m) 4\n");
  EXPECT_EQ(r.codes(), "GL5105 GL5105") << "warnings";
  ASSERT_TRUE(r.mission);
  EXPECT_EQ(r.mission->behaviours[0].value("d_target_depth"), 4);
  EXPECT_EQ(r.mission->behaviours[0].arguments.size(), 2U);
  EXPECT_EQ(r.mission->sensors.at(0).value, 0);
  const Reading file = arguments(
      "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 3\n"
      "b_arg: d_target_depth(m) 44\n<end:b_arg>\n");
  EXPECT_EQ(file.codes(), "GL5105");
  ASSERT_TRUE(file.arguments);
  EXPECT_EQ(file.arguments->arguments.at(0).value, 44);
}

TEST(MissionFile, KnowsTheArgumentsThatTheSimulatorDoesNotModel) {
  EXPECT_EQ(mission("behavior: drift_at_depth\n b_arg: use_thruster(enum) 0\n"
                    " b_arg: thruster_value(X) 0\n b_arg: depth_pitch_limit(rad) 0.174\n"
                    " b_arg: pressure_median(bool) 1\n b_arg: alt_time(s) 120\n"
                    " b_arg: bpump_deadz_width(cc) 30\n b_arg: battpos_db(nodim) 1\n"
                    "behavior: climb_to\n b_arg: stop_when_air_pump(bool) 0\n"
                    " b_arg: initial_inflection(bool) 1\n"
                    "behavior: goto_wpt\n b_arg: utm_zd(byte) 19\n b_arg: utm_zc(byte) 19\n"
                    "behavior: nop_cmds\n b_arg: nop_air_pump(bool) 1\n"
                    "behavior: abend\n b_arg: remaining_charge_sample_time(sec) 60\n")
                .codes(),
            "");
}

TEST(MissionFile, ShowsPlaceCaretAndSuggestion) {
  const std::string text = mission("behavior: yo\n  b_arg: d_target_dept(m) 3\n").text();
  EXPECT_NE(text.find("test.mi:2:10: error: behaviour `yo` has no argument `d_target_dept`"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("did you mean `d_target_depth`?"), std::string::npos) << text;
}

TEST(MissionFile, SurvivesHostileInput) {
  EXPECT_EQ(mission(std::string("behavior: yo\0", 13)).codes(), "GL5109");
  EXPECT_EQ(mission(std::string((size_t{1} << 20U) + 1, ' ')).codes(), "GL5109");
  EXPECT_TRUE(mission("").mission)
      << "an empty file is a mission without behaviours";  // accepts: GL5109
  EXPECT_EQ(mission("behavior: " + std::string(100000, 'x') +
                    "\n b_arg: " + std::string(100000, 'y') + "(m) 3\n")
                .codes(),
            "");
  EXPECT_EQ(mission("\xff\xfe\x01:\n").codes(), "GL5100");
  EXPECT_EQ(mission("b_arg:").codes(), "GL5100");
  EXPECT_EQ(mission(":").codes(), "GL5100");
  std::string noise;
  for (uint32_t i = 0, x = 1; i < 20000; ++i) {
    x = x * 1664525U + 1013904223U;
    noise += static_cast<char>(x >> 24U | 1U);
  }
  EXPECT_NE(mission(noise).codes(), "");
}

TEST(ArgumentFile, ReadsArgumentsAndWaypointsLongitudeFirst) {
  const Reading r = arguments(
      "behavior_name=Goto_list\n<start:b_arg>\nb_arg: num_waypoints(nodim) 2\n<end:b_arg>\n"
      "<start:waypoints>\n-7032.0640 4138.1060\n#1 2\n725.8 5418.00\n<end:waypoints>\n");
  ASSERT_TRUE(r.arguments) << r.text();
  EXPECT_EQ(r.arguments->behaviour, "goto_list");
  ASSERT_EQ(r.arguments->waypoints.size(), 2U);
  EXPECT_EQ(r.arguments->waypoints[0].longitude_ddmm, -7032.0640);
  EXPECT_EQ(r.arguments->waypoints[0].latitude_ddmm, 4138.1060);
}

TEST(ArgumentFile, PointsAtEachError) {
  EXPECT_EQ(arguments("").codes(), "GL5112");
  EXPECT_EQ(arguments("<start:b_arg>\n<end:b_arg>\n").codes(), "GL5112 GL5112");
  EXPECT_EQ(arguments("behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 3\n").codes(),
            "GL5112");
  EXPECT_EQ(arguments("behavior_name=yo\nb_arg: d_target_depth(m) 3\n").codes(), "GL5112");
  EXPECT_EQ(
      arguments("behavior_name=goto_list\n<start:waypoints>\n-7360.0 3910.5\n<end:waypoints>\n")
          .codes(),
      "GL5114");
  EXPECT_EQ(
      arguments("behavior_name=goto_list\n<start:waypoints>\n3910.5\n<end:waypoints>\n").codes(),
      "GL5100");
  // accepts: GL5112 GL5114
  EXPECT_EQ(
      arguments("behavior_name=goto_list\n<start:waypoints>\n-7359.9 3910.5\n<end:waypoints>\n")
          .codes(),
      "");
}

TEST(ArgumentFile, TextAfterAWaypointIsIgnored) {
  const Reading r = arguments(
      "behavior_name=goto_list\n<start:waypoints>\n-7349.5 3910.5 north end\n"
      "-7349.0 3910.0 1\n-7348.5 3910.0 # south end\n<end:waypoints>\n");
  EXPECT_EQ(r.codes(), "GL5207 GL5207") << "warnings";
  ASSERT_TRUE(r.arguments);
  ASSERT_EQ(r.arguments->waypoints.size(), 3U);
  EXPECT_EQ(r.arguments->waypoints[0].latitude_ddmm, 3910.5);
  EXPECT_NE(r.text().find("test.ma:3:16: warning: `north end` after the waypoint is ignored"),
            std::string::npos)
      << r.text();
  // accepts: GL5207
  EXPECT_EQ(arguments("behavior_name=goto_list\n<start:waypoints>\n-7349.5 3910.5\n"
                      "<end:waypoints>\n")
                .codes(),
            "");
}

// accepts: GL5113
TEST(ArgumentFile, GoesBeforeTheMissionFile) {
  const fs::path folder = fs::path(testing::TempDir()) / "argument_files";
  fs::create_directories(folder);
  ASSERT_TRUE(support::writeFileAtomically(
      folder / "yo07.ma",
      "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 44\n<end:b_arg>\n"));
  ASSERT_TRUE(support::writeFileAtomically(folder / "surfac07.ma", "behavior_name=yo\n"));
  Reading r = mission(
      "behavior: yo\n b_arg: args_from_file(enum) 7\n b_arg: d_target_depth(m) 3\n");  // accepts:
  applyArgumentFiles(*r.mission, folder, r.sources, r.diagnostics);
  EXPECT_EQ(r.mission->behaviours[0].value("d_target_depth"), 44);
  EXPECT_EQ(r.codes(), "");
  Reading wrong = mission("behavior: surface\n b_arg: args_from_file(enum) 7\n");
  applyArgumentFiles(*wrong.mission, folder, wrong.sources, wrong.diagnostics);
  EXPECT_EQ(wrong.codes(), "GL5113");
  Reading missing = mission("behavior: yo\n b_arg: args_from_file(enum) 8\n");
  applyArgumentFiles(*missing.mission, folder, missing.sources, missing.diagnostics);
  EXPECT_EQ(missing.codes(), "GL9001");
  // accepts: GL5115
  Reading sample = mission("behavior: sample\n b_arg: args_from_file(enum) 8\n");
  applyArgumentFiles(*sample.mission, folder, sample.sources, sample.diagnostics);
  EXPECT_EQ(sample.codes(), "GL5115") << "glidercc does not need it";
  EXPECT_TRUE(sample.mission->behaviours[0].lacks_file);
  Reading unknown = mission("behavior: pinger_on\n b_arg: args_from_file(enum) 8\n");
  applyArgumentFiles(*unknown.mission, folder, unknown.sources, unknown.diagnostics);
  EXPECT_EQ(unknown.codes(), "GL5115");
  Reading prepare = mission("behavior: prepare_to_dive\n b_arg: args_from_file(enum) 8\n");
  applyArgumentFiles(*prepare.mission, folder, prepare.sources, prepare.diagnostics);
  EXPECT_EQ(prepare.codes(), "GL9001") << "it moves the vehicle";
  fs::create_directories(folder / "mafiles");
  ASSERT_TRUE(support::writeFileAtomically(
      folder / "mafiles/yo09.ma",
      "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 45\n<end:b_arg>\n"));
  Reading beside = mission("behavior: yo\n b_arg: args_from_file(enum) 9\n");
  applyArgumentFiles(*beside.mission, folder, beside.sources, beside.diagnostics);
  EXPECT_EQ(beside.codes(), "");
  EXPECT_EQ(beside.mission->behaviours[0].value("d_target_depth"), 45);
  ASSERT_TRUE(support::writeFileAtomically(
      folder / "goto_l01.ma",
      "behavior_name=goto_list\n<start:waypoints>\n-7359.9 3910.5\n713 5433.5\n<end:waypoints>\n"));
  Reading list = mission("behavior: goto_list\n b_arg: args_from_file(enum) 1\n");
  applyArgumentFiles(*list.mission, folder, list.sources, list.diagnostics);
  ASSERT_EQ(list.mission->behaviours[0].waypoints.size(), 2U);
  EXPECT_EQ(list.mission->behaviours[0].waypoints[1].longitude_ddmm, 713);
  Reading fraction = mission("behavior: yo\n b_arg: args_from_file(enum) 1e30\n");
  applyArgumentFiles(*fraction.mission, folder, fraction.sources, fraction.diagnostics);
  EXPECT_EQ(fraction.codes(), "GL5107");
  fs::remove_all(folder);
}

TEST(MissionFile, ReadsRealPublicMissions) {
  const fs::path folder = fs::path(GLIDER_SOURCE_DIR) / "../shared/data/missions";
  if (!fs::exists(folder)) {
    GTEST_SKIP() << "the real mission files are not here: " << folder;
  }
  size_t read = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".mi" && extension != ".ma") {
      continue;
    }
    auto text = support::readFile(entry.path());
    ASSERT_TRUE(text);
    const Reading r = extension == ".mi" ? mission(std::move(*text)) : arguments(std::move(*text));
    EXPECT_EQ(r.codes(), "") << entry.path() << "\n" << r.text();
    ++read;
  }
  EXPECT_GE(read, 14U);
}

}  // namespace
}  // namespace glider::slocum
