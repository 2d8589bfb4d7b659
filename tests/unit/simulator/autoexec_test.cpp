// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// autoexec.mi and the argument files of a mission, in the folders of the vehicle.

#include "simulator/slocum/flight/mission_variables.h"
#include "simulator/slocum/flight/skeleton.h"
#include "support/diagnostics/render.h"
#include "support/files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace glider::simulator {
namespace {

namespace fs = std::filesystem;

/// A folder of mission files, as the vehicle has them.
class Folder {
 public:
  /// Of its own: tests run beside each other.
  Folder()
      : path_(fs::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(path_);
    fs::create_directories(path_ / "missions/config");
    fs::create_directories(path_ / "config");
    write("missions/m.mi", "sensor: c_alt_time(sec) 8\nbehavior: yo\n");
  }
  void write(const char* name, const std::string& text) const {
    ASSERT_TRUE(support::writeFileAtomically(path_ / name, text));
  }
  void remove(const char* name) const { fs::remove(path_ / name); }
  /// The settings in force, and the codes of what was reported.
  std::pair<MissionVariables, std::string> load(const char* name = "missions/m.mi") {
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    const auto mission = loadMissionFile(path_ / name, sources, diagnostics);
    std::string codes;
    for (const auto& diagnostic : diagnostics.sorted()) {
      codes += support::code(diagnostic.id) + " ";
    }
    rendered = support::render(diagnostics, sources, false);
    return {MissionVariables(mission ? *mission : slocum::MissionFile{}), codes};
  }
  std::string rendered;

 private:
  fs::path path_;
};

TEST(Autoexec, StandsBelowTheMission) {
  Folder folder;
  const std::string autoexec =
      "name unit_999\nsensor: c_alt_time(sec) 4\nsensor: u_mission_param_a(X) 7\n";
  for (const char* place :
       {"missions/autoexec.mi", "missions/config/autoexec.mi", "config/autoexec.mi"}) {
    folder.write(place, autoexec);
    const auto [settings, codes] = folder.load();
    EXPECT_EQ(codes, "") << folder.rendered;
    EXPECT_EQ(settings.find("c_alt_time"), 8) << place;
    EXPECT_EQ(settings.find("u_mission_param_a"), 7) << place;
    folder.remove(place);
  }
  // The nearest one is the vehicle's.
  folder.write("config/autoexec.mi", "sensor: u_mission_param_a(X) 1\n");
  folder.write("missions/config/autoexec.mi", "sensor: u_mission_param_a(X) 3\n");
  EXPECT_EQ(folder.load().first.find("u_mission_param_a"), 3);
  folder.write("missions/autoexec.mi", "sensor: u_mission_param_a(X) 2\n");
  EXPECT_EQ(folder.load().first.find("u_mission_param_a"), 2);
  folder.write("missions/m.mi", "behavior: sensors_in\n b_arg: c_alt_time(sec) 12\nbehavior: yo\n");
  folder.write("missions/autoexec.mi", autoexec);
  EXPECT_EQ(folder.load().first.find("c_alt_time"), 12) << "and below the behaviour";
}

TEST(Autoexec, BehavioursWhoseFileIsMissingHaveNoEffect) {
  Folder folder;
  folder.write("missions/m.mi",
               "sensor: c_alt_time(sec) 8\nbehavior: yo\n"
               "behavior: sensors_in\n b_arg: args_from_file(enum) 3\n b_arg: c_alt_time(sec) 9\n"
               " b_arg: c_flntu_on(sec) 0\n");
  const auto [settings, codes] = folder.load();
  EXPECT_EQ(codes, "GL5115 ") << "and nothing of its arguments";
  EXPECT_EQ(settings.find("c_alt_time"), 8);
}

TEST(Autoexec, AnArgumentFileMayListAnotherNumberOfWaypoints) {
  Folder folder;
  folder.write("missions/m.mi", "behavior: goto_list\n b_arg: args_from_file(enum) 10\n");
  const auto listing = [&](int stated) {
    folder.write("missions/goto_l10.ma",
                 fmt::format("behavior_name=goto_list\n<start:b_arg>\n"
                             "b_arg: num_waypoints(nodim) {}\n<end:b_arg>\n<start:waypoints>\n"
                             "-7349.5 3910.5\n-7349.0 3910.0\n<end:waypoints>\n",
                             stated));
    return folder.load().second;
  };
  EXPECT_EQ(listing(4), "GL5209 ") << "a warning: those that are listed are flown";
  EXPECT_EQ(listing(1), "GL5209 ");
  EXPECT_EQ(listing(2), "");  // accepts: GL5209
}

TEST(Autoexec, SettingsWithoutEffectAreNamedOnce) {
  Folder folder;
  folder.write("missions/autoexec.mi",
               "sensor: c_alt_time(sec) 4\nsensor: f_one(X) 1\nsensor: f_two(X) 1\n"
               "sensor: f_three(X) 1\n");
  EXPECT_EQ(folder.load().second, "GL5111 ");
  EXPECT_NE(folder.rendered.find("setting `f_one` has no effect"), std::string::npos);
  EXPECT_NE(folder.rendered.find("nor have, of this file: `f_two`, `f_three`\n"), std::string::npos)
      << folder.rendered;
  std::string many;
  for (int i = 1; i <= 14; ++i) {
    many += "sensor: f_" + std::to_string(i) + "(X) 1\n";
  }
  folder.write("missions/autoexec.mi", many);
  EXPECT_EQ(folder.load().second, "GL5111 ");
  EXPECT_NE(folder.rendered.find("`f_11`, `f_12` and 2 more\n"), std::string::npos)
      << folder.rendered;
  folder.write("missions/autoexec.mi", "sensor: f_one(X) 1\n");
  EXPECT_EQ(folder.load().second, "GL5111 ");
  EXPECT_EQ(folder.rendered.find("nor have"), std::string::npos) << folder.rendered;
  EXPECT_EQ(folder.load("missions/autoexec.mi").second, "GL5205 GL5111 ")
      << "it is read once also as the mission";
  folder.write("missions/autoexec.mi", "sensor: f_one 1\n");
  EXPECT_EQ(folder.load().second, "GL5100 ") << "an error there is one of the mission";
}

}  // namespace
}  // namespace glider::simulator
