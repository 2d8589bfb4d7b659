// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is proved about the mission file that flies with a program at the vehicle's port: the
// written one, and twins of it with a fault each, which are refused.

#include "vehicles/slocum/rules/port/port_whole.h"

#include "hooks/extctl/port.h"
#include "platforms/load/load_platform.h"
#include "support/source_manager.h"
#include "vehicles/slocum/mission_files/read.h"
#include "vehicles/slocum/rules/port/port_doubts.h"
#include "vehicles/slocum/rules/port/port_masks.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>

namespace glider::slocum::rules {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const platforms::Platform& slocum() {
  static const auto loaded = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  return *loaded;
}

std::string written(double deepest_m = 40, double after_s = 3600) {
  const auto plan = planPort("survey", "text", slocum(), {},
                             {.greatest_depth_m = deepest_m, .surface_after_s = after_s});
  EXPECT_TRUE(plan.has_value());
  return printPortMission(*plan);
}

MissionFile read(const std::string& text) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  auto mission = readMission(sources, sources.add("survey.mi", text), diagnostics);
  EXPECT_TRUE(mission) << text;
  return mission ? *mission : MissionFile{};
}

Whole of(const std::string& text) {
  const MissionFile file = read(text);
  EXPECT_TRUE(isPortFile(file));
  return portWhole(file, portFileOf(file, slocum()), slocum());
}

std::string changed(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

/// Why `text` is refused after silence; "" if it is proved.
std::string refusal(const std::string& text) {
  const Whole whole = of(text);
  for (const Ending& ending : whole.endings) {
    if (!ending.proved()) {
      return ending.why_not;
    }
  }
  return "";
}

TEST(PortWhole, TheWrittenFileBringsTheVehicleUpByItsTimer) {
  const Whole whole = of(written());
  ASSERT_TRUE(whole.proved());
  const Ending& silence = whole.endings.front();
  EXPECT_EQ(silence.by, "behaviour 2 `surface` (start_when 12, when_secs 3600)");
  // abend at 50 m, seen 20 s late, and the overshoot: from 63 m.
  EXPECT_DOUBLE_EQ(whole.deepest_m, 50 + 5 + 0.4 * 20);
  EXPECT_DOUBLE_EQ(silence.seconds(), 3600 + 20 + 120 + 63 / 0.05);
  EXPECT_DOUBLE_EQ(of(written(20, 7200)).endings.front().seconds(), 7200 + 20 + 120 + 43 / 0.05);
}

TEST(PortWhole, AFileWithoutTheTimerIsRefused) {
  EXPECT_THAT(refusal(changed(written(), "start_when(enum) 12", "start_when(enum) 5")),
              HasSubstr("flies on without an end"));
  EXPECT_THAT(refusal(changed(written(), "when_secs(s) 3600", "when_secs(s) 1000004")),
              HasSubstr("behaviour 5 `yo`"));
}

/// What stands above replaces the commands of what stands below.
TEST(PortWhole, AYoAboveTheTimerIsRefused) {
  const std::string text = written();
  const auto timer = text.find("\n# Without contact");
  const auto next = text.find("\n# The SBC commands the surface.");
  const std::string moved =
      text.substr(0, timer) + text.substr(next) + text.substr(timer, next - timer);
  EXPECT_THAT(refusal(moved), HasSubstr("stands above"));
}

/// A damaged sentence may command any depth.
TEST(PortWhole, AFileWithoutAFixedOverdepthIsRefused) {
  for (const char* value : {"-1", "1000003", "10000"}) {
    const std::string overdepth = std::string("overdepth(m) ") + value;
    EXPECT_THAT(refusal(changed(written(), "overdepth(m) 50", overdepth)), HasSubstr("any depth"))
        << value;
  }
}

TEST(PortWhole, AnOverdepthThatIsSeldomLookedAtIsRefused) {
  for (const char* value : {"-1", "3600"}) {
    EXPECT_THAT(refusal(changed(written(), "overdepth_sample_time(s) 15",
                                std::string("overdepth_sample_time(s) ") + value)),
                HasSubstr("any depth"))
        << value;
  }
}

TEST(PortWhole, ADiveAboveTheSbcsYoIsRefused) {
  const std::string dive =
      "\nbehavior: dive_to\n    b_arg: target_depth(m) 70\n    b_arg: use_pitch(enum) 3\n"
      "    b_arg: pitch_value(X) -0.45\n";
  const std::string text = changed(written(), "\n# The SBC commands the surface.",
                                   dive + "\n# The SBC commands the surface.");
  EXPECT_THAT(refusal(text), HasSubstr("stands above the `yo` of the SBC"));
}

TEST(PortWhole, ASettingThatIsNotKnownIsRefused) {
  EXPECT_THAT(refusal("sensor: u_pitch_max(rad) 0.1\n" + written()), HasSubstr("u_pitch_max"));
}

/// What `text` keeps from being obeyed, the first of it.
std::string doubtIn(const std::string& text) {
  const MissionFile file = read(text);
  const auto doubts = portDoubts(file, portFileOf(file, slocum()), slocum());
  return doubts.empty() ? "" : doubts.front().what;
}

TEST(PortDoubts, TheWrittenFilesHaveNone) {
  EXPECT_EQ(doubtIn(written()), "");
  const auto modes = planPort("survey", "text", slocum(), {},
                              {.release = Release::MissionModes, .greatest_depth_m = 200});
  EXPECT_EQ(doubtIn(printPortMission(*modes)), "");
  EXPECT_EQ(refusal(printPortMission(*modes)), "");
}

TEST(PortDoubts, AYoThatDoesNotFlyWhatTheSbcCommandsIsNamed) {
  const struct {
    const char* what;
    const char* by;
    const char* named;
  } rows[] = {
      {"c_bpump_value(X) 1000\n    b_arg: c_use_pitch(enum) 3\n    b_arg: c_pitch_value(X) 1000006",
       "c_bpump_value(X) -1000\n    b_arg: c_use_pitch(enum) 3\n    b_arg: c_pitch_value(X) "
       "1000006",
       "c_bpump_value -1000"},
      {"d_bpump_value(X) -1000", "d_bpump_value(X) -50", "d_bpump_value -50"},
      {"c_pitch_value(X) 1000006", "c_pitch_value(X) 1000005", "takes its c_pitch_value"},
      {"c_target_altitude(m) -1", "c_target_altitude(m) 5", "c_target_altitude 5"},
      {"num_half_cycles_to_do(nodim) -1", "num_half_cycles_to_do(nodim) 4",
       "num_half_cycles_to_do 4"},
      {"d_use_pitch(enum) 3\n    b_arg: d_pitch_value(X) 1000005",
       "d_use_pitch(enum) 3\n    b_arg: c_stop_when_stalled_for(s) 0\n    b_arg: "
       "d_pitch_value(X) 1000005",
       "c_stop_when_stalled_for 0"},
      {"heading_value(X) 1000000", "heading_value(X) 1000001", "no `set_heading`"},
      {"start_when(enum) 11", "start_when(enum) 5", "no `surface` starts"},
      {"start_when(enum) 11", "start_when(enum) 15", "no `surface` starts"},
      {"start_when(enum) 11\n    b_arg: end_action(enum) 2",
       "start_when(enum) 11\n    b_arg: end_action(enum) 0", "end_action 0"},
      {"u_mission_param_d(m) 3", "u_mission_param_d(m) 60", "u_mission_param_d is 60"},
      {"u_mission_param_e(m) 1", "u_mission_param_e(m) 50", "u_mission_param_e is 50"},
      {"sci_wants_surface(enum) 2", "sci_wants_surface(enum) 0", "sci_wants_surface is 0"},
  };
  for (const auto& [what, by, named] : rows) {
    EXPECT_THAT(doubtIn(changed(written(), what, by)), HasSubstr(named)) << by;
  }
}

TEST(PortMasks, WhatReplacesTheSbcsCommandsForATimeIsNamed) {
  const auto masksOf = [](const std::string& text) {
    const MissionFile file = read(text);
    return portMasks(file, portFileOf(file, slocum()));
  };
  EXPECT_THAT(masksOf(written()), IsEmpty());
  const std::string sbc = "\n# The SBC commands the surface.";
  const std::string every =
      "\nbehavior: surface\n    b_arg: start_when(enum) 9\n"
      "    b_arg: when_secs(s) 1800\n    b_arg: end_action(enum) 1\n";
  const auto surfaces = masksOf(changed(written(), sbc, every + sbc));
  ASSERT_THAT(surfaces, SizeIs(1));
  EXPECT_THAT(surfaces.front().what, HasSubstr("behaviour 3 `surface` brings the vehicle"));
  const std::string heading =
      "\nbehavior: set_heading\n    b_arg: use_heading(bool) 1\n"
      "    b_arg: heading_value(X) 1\n    b_arg: start_when(enum) 0\n";
  EXPECT_THAT(masksOf(changed(written(), sbc, heading + sbc)), SizeIs(1));
  EXPECT_THAT(masksOf(written() + heading), IsEmpty()) << "below, it replaces nothing";
}

TEST(PortFile, AFileWithHookbehOrWithoutTheNumberIsNotOne) {
  EXPECT_FALSE(isPortFile(read(changed(written(), "sensor: u_mission_param_l", "# "))));
  EXPECT_FALSE(
      isPortFile(read(changed(written(), "d_target_depth(m) 1000003", "d_target_depth(m) 30"))));
}

TEST(PortFile, ByThePortTheVehicleObeysLaterAndHoldsBelow) {
  platforms::Platform wide = slocum();
  widenForPort(wide, 300);
  EXPECT_EQ(wide.world.command_delay_s,
            2 * hooks::extctl::kSettleSecs + slocum().world.tick_gap_s + 300);
  EXPECT_EQ(wide.world.climb_hold_m, 10);
  EXPECT_DOUBLE_EQ(wide.world.depth_error_m, 0.9 + 0.4 * 8);
}

}  // namespace
}  // namespace glider::slocum::rules
