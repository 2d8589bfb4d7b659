// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Goldens of the vehicle's own mission files: below each, in lines that begin with `#| `, what
// `check --mi` says of it on standard error; below a mission what `check --scenario default` says.
// A line `# mission: NAME` names one of whole/missions. expects: GL3130 GL3131 GL3132 GL3133 GL3134
// accepts: GL3124 GL3125 GL3126 GL3130 GL3131 GL3132 GL3133 GL3134

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glider::tests {
namespace {

const std::string kFolder = GLIDER_SOURCE_DIR "/tests/golden/whole";
constexpr const char* kMission = "../../../missions/gallery/thermocline.mission";

std::string expectedOf(const std::filesystem::path& golden) {
  constexpr std::string_view kMark = "#|";
  std::ifstream in(golden);
  std::string expected;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kMark)) {
      expected += line.size() > kMark.size() ? line.substr(kMark.size() + 1) + "\n" : "\n";
    }
  }
  return expected;
}

/// The mission that is checked with a golden.
std::string missionOf(const std::filesystem::path& golden) {
  constexpr std::string_view kMark = "# mission: ";
  std::ifstream in(golden);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kMark)) {
      return "missions/" + line.substr(kMark.size()) + ".mission";
    }
  }
  return kMission;
}

TEST(WholeGoldens, SayWhatTheVehicleDoesOtherwise) {
  int refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.is_directory()) {
      continue;
    }
    const std::string name = entry.path().filename().string();
    const std::string how = name.ends_with(".mission")
                                ? "--scenario default " + name
                                : "--mi " + name + " " + missionOf(entry.path());
    const Outcome outcome = runShell("cd " + kFolder + " && $GLIDERCC check " + how);
    const bool fails = name.starts_with("fail_");
    refused += fails;
    EXPECT_EQ(outcome.status, fails ? 1 : 0) << name << outcome.err;
    const std::string expected = expectedOf(entry.path());
    EXPECT_EQ(expected.empty(), name.starts_with("ok_")) << name;
    EXPECT_THAT(outcome.err, testing::StartsWith(expected)) << name;
    EXPECT_EQ(outcome.err.find("[GL31") != std::string::npos, !name.starts_with("ok_"))
        << name << outcome.err;
  }
  EXPECT_GE(refused, 3);
}

constexpr const char* kYo = "behavior: yo\n";
constexpr const char* kHeading =
    "behavior: set_heading\nb_arg: use_heading(bool) 1\nb_arg: heading_value(X) 1\n";

/// What stands below a hookbeh that never gets control and a surface behaviour that starts within
/// an hour, and whether a slot is idle in some cycle.
std::vector<std::pair<std::string, bool>> stacks() {
  const std::string yo = kYo, heading = kHeading,
                    wpt =
                        "behavior: goto_wpt\nb_arg: wpt_x(X) 1\n"
                        "b_arg: wpt_y(X) 1\n";
  const std::string list = "behavior: goto_list\nb_arg: num_waypoints(nodim) 1\n";
  const std::string nop = "behavior: nop_cmds\nb_arg: nop_heading(bool) 1\n";
  return {
      {yo + heading, false},
      {yo, true},
      {heading, true},
      {yo + heading + "b_arg: start_when(enum) 2\n", false},
      {heading + "b_arg: start_when(enum) 2\n" + yo, true},
      {yo + heading + "b_arg: stop_when(enum) 9\n", true},
      {yo + wpt + "b_arg: stop_when(enum) 5\n", false},
      {yo + wpt, true},
      {yo + list, false},
      {yo + list + "b_arg: num_legs_to_run(nodim) 1\n", true},
      {yo + nop, false},
      {yo + nop + "b_arg: secs_to_run(s) 60\n", true},
      {heading + yo + "b_arg: start_when(enum) 8\n", true},
      {heading + yo + "b_arg: num_half_cycles_to_do(nodim) 4\n", true},
      {heading + "behavior: climb_to\nb_arg: end_action(enum) 2\nb_arg: use_pitch(enum) 3\n"
                 "b_arg: pitch_value(X) 0.4\n",
       true},
      {heading + "behavior: drift_at_depth\nb_arg: target_depth(m) 10\n"
                 "b_arg: stop_when_hover_for(s) 600\n",
       true},
      {"behavior: surface\nb_arg: start_when(enum) 1\nb_arg: end_action(enum) 2\n", false},
  };
}

/// The simulator aborts the files that are refused because a slot is idle, and no others.
TEST(WholeGoldens, AnIdleStackIsRefusedIfTheVehicleAborts) {
  const TemporaryFolder folder;
  for (const auto& [behaviours, idle] : stacks()) {
    const std::string file =
        folder
            .write("a.mi",
                   "behavior: surface\nb_arg: start_when(enum) 12\nb_arg: when_secs(s) "
                   "3600\nb_arg: end_action(enum) 2\nbehavior: hookbeh\n" +
                       behaviours)
            .string();
    const Outcome checked =
        runShell("cd " + kFolder + " && $GLIDERCC check --mi " + file + " " + kMission);
    EXPECT_EQ(checked.err.find("and the vehicle aborts") != std::string::npos, idle)
        << behaviours << checked.err;
    const Outcome flown =
        runShell("$GLIDERCC sim " + file + " -o " + (folder.path() / "flight").string());
    EXPECT_EQ(flown.err.find("_IS_IDLE") != std::string::npos, idle) << behaviours << flown.err;
  }
}

TEST(WholeGoldens, TheReportHasALineForEachEnding) {
  const Outcome outcome =
      runShell("cd " + kFolder +
               " && $GLIDERCC check --report --target host --skeleton " GLIDER_SOURCE_DIR
               "/scenarios/skeleton.mi " +
               kMission);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::HasSubstr("\nafter silence of the SBC the vehicle is at the "
                                              "surface within 14 min 12 s, by behaviour 3 "
                                              "`surface` (start_when 1): silence_secs 24 s"));
}

}  // namespace
}  // namespace glider::tests
