// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is proved about the vehicle's own mission file after control ends: the bundled files with
// their times, and twins of them with a fault each, which are refused.

#include "vehicles/slocum/rules/whole.h"

#include "tests/support/command.h"
#include "vehicles/slocum/mission_files/load.h"
#include "vehicles/slocum/rules/refused_commands.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace glider::slocum::rules {
namespace {

platforms::Platform hull() {
  platforms::Platform platform;
  platform.envelope.greatest_depth_m = 200;
  platform.envelope.steepest_pitch_rad = 0.7854;
  platform.envelope.shallowest_pitch_rad = 0.19;
  platform.envelope.vertical_rate_m_s = 0.4;
  platform.envelope.inflection_overshoot_m = 5;
  platform.envelope.pump_cc = 233;
  platform.envelope.cycle_s = 4;
  platform.world.slowest_climb_m_s = 0.05;
  platform.world.turn_s = 120;
  platform.world.tick_gap_s = 20;
  platform.world.start_depth_m = 3;
  platform.world.surface_depth_m = 2;
  platform.world.line_lag_s = 8;
  return platform;
}

constexpr double kDeepest = 25;          // m, of the mission's commands
constexpr double kLetsGo = 24 + 40 + 8;  // s: silence_secs, two cycles and the line
constexpr double kUnanswered = 120;      // s: six ticks
constexpr double kClimb = 120 + 500;     // s, from 25 m

class WholeOf : public ::testing::Test {
 protected:
  [[nodiscard]] Whole of(const std::string& text, double deepest_m = kDeepest,
                         const platforms::Platform& platform = hull(), bool naps = false) const {
    const std::string path = folder_.write("a.mi", text).string();
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    const auto mission = slocum::loadMission(path, sources, diagnostics, [](auto&&...) {});
    EXPECT_TRUE(mission) << path;
    return mission ? wholeOf(*mission, platform, deepest_m, naps) : Whole{};
  }
  [[nodiscard]] static std::string shipped(const std::string& name) {
    return tests::slurp(std::string(GLIDER_SOURCE_DIR) + "/scenarios/" + name);
  }
  /// Why `text` is refused after the silence of the SBC; "" if it is proved.
  [[nodiscard]] std::string refusal(const std::string& text) const {
    return after(of(text), "silence of the SBC").why_not;
  }
  [[nodiscard]] double seconds(const std::string& text) const {
    const Ending ending = after(of(text), "silence of the SBC");
    EXPECT_EQ(ending.why_not, "") << text;
    return ending.seconds();
  }
  static Ending after(const Whole& whole, const std::string& what) {
    const auto found = std::ranges::find_if(
        whole.endings, [&](const Ending& ending) { return ending.after.starts_with(what); });
    EXPECT_NE(found, whole.endings.end()) << what;
    return found == whole.endings.end() ? Ending{} : *found;
  }
  const tests::TemporaryFolder folder_;
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

std::string behaviour(const std::string& name, const std::string& arguments) {
  std::string text = "behavior: " + name + "\n";
  for (size_t at = 0; at < arguments.size();) {
    const size_t end = std::min(arguments.find(',', at), arguments.size());
    text += "    b_arg: " + arguments.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return text;
}

const std::string kIdle = behaviour("surface", "start_when(enum) 1,end_action(enum) 2");
const std::string kHookbeh = behaviour("hookbeh", "max_depth(m) 60");
const std::string kHeading = behaviour("set_heading", "use_heading(bool) 1,heading_value(X) 1");

TEST_F(WholeOf, TheSkeletonIsAtTheSurfaceInTheTimeOfTheWayHome) {
  const Whole whole = of(shipped("skeleton.mi"));
  EXPECT_TRUE(whole.proved());
  EXPECT_DOUBLE_EQ(after(whole, "silence of the SBC").seconds(), kLetsGo + kClimb);
  EXPECT_DOUBLE_EQ(after(whole, "`exit`").seconds(), kUnanswered + kLetsGo + kClimb);
  EXPECT_DOUBLE_EQ(after(whole, "instructions").seconds(), kUnanswered + kLetsGo + kClimb);
  EXPECT_DOUBLE_EQ(after(whole, "masking by behaviour 2").seconds(), kClimb);
  EXPECT_DOUBLE_EQ(after(whole, "masking by behaviour 3").seconds(), kClimb);
  // 70 m, in 20 s of a cycle 8 m more, and 5 m while it turns
  EXPECT_DOUBLE_EQ(after(whole, "an abort (overdepth 70)").seconds(), 120 + 83 / 0.05);
  EXPECT_DOUBLE_EQ(after(whole, "an abort (overtime 43200").seconds(), kClimb);
  EXPECT_EQ(after(whole, "silence of the SBC").by, "behaviour 3 `surface` (start_when 1)");
}

TEST_F(WholeOf, TheSkeletonAllowsTheDepthThatTheReportNames) {
  const auto line = fmt::format("b_arg: max_depth(m)        {:.0f}\n", kBundledGreatestDepth_m);
  EXPECT_NE(shipped("skeleton.mi").find(line), std::string::npos);
}

/// A yo of so many legs goes on below hookbeh, and then the stack is idle.
TEST_F(WholeOf, TheFilesWithAYoSurfaceAfterItsLegs) {
  const Whole first = of(shipped("first_deployment.mi"));
  EXPECT_TRUE(first.proved());
  const double leg = 120 + 25 / 0.05 + 240 + 20;
  EXPECT_DOUBLE_EQ(after(first, "silence of the SBC").seconds(), kLetsGo + 4 * leg + kClimb);
  const Whole figure5 = of(shipped("figure5.mi"));
  EXPECT_TRUE(figure5.proved());
  EXPECT_EQ(figure5.deepest_m, 35);
  const double deeper = 120 + 35 / 0.05 + 240 + 20;
  EXPECT_DOUBLE_EQ(after(figure5, "silence of the SBC").seconds(),
                   kLetsGo + 6 * deeper + 120 + 35 / 0.05);
}

TEST_F(WholeOf, TheDepthIsTheLesserOfTheMissionsAndHookbehs) {
  EXPECT_EQ(of(kIdle + kHookbeh).deepest_m, 25);
  EXPECT_EQ(of(kIdle + kHookbeh, 500).deepest_m, 65);
  EXPECT_EQ(of(kIdle + behaviour("hookbeh", "max_depth(m) 900"), 500).deepest_m, 205);
  // And a dive below goes to its own target.
  EXPECT_EQ(of(kIdle + kHookbeh +
               behaviour("dive_to", "target_depth(m) 70,use_pitch(enum) 3,pitch_value(X) -0.45"))
                .deepest_m,
            75);
  EXPECT_EQ(of(kIdle + kHookbeh +
               behaviour("climb_to", "target_depth(m) 70,use_pitch(enum) 3,pitch_value(X) 0.45"))
                .deepest_m,
            25);
}

/// Control may begin below hookbeh's max_depth; it then climbs, after the overshoot.
TEST_F(WholeOf, AStartBelowHookbehsDepthCounts) {
  platforms::Platform deep = hull();
  deep.world.start_depth_m = 50;
  const Whole whole = of(kIdle + behaviour("hookbeh", "max_depth(m) 30"), 55, deep);
  EXPECT_EQ(whole.deepest_m, 55);
  EXPECT_DOUBLE_EQ(after(whole, "silence of the SBC").seconds(), kLetsGo + 120 + 55 / 0.05);
  EXPECT_EQ(of(kIdle + behaviour("hookbeh", "max_depth(m) 30"), 500, deep).deepest_m, 55);
  EXPECT_EQ(of(kIdle + behaviour("hookbeh", "max_depth(m) -10"), 25).deepest_m, 8);
}

TEST_F(WholeOf, TheLinesNameTheBehaviourTheTimeAndItsParts) {
  const auto lines = wholeLines(of(shipped("skeleton.mi")));
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0],
            "after `exit`, instructions that get no answer the vehicle is at the surface within "
            "13 min 32 s, by behaviour 3 `surface` (start_when 1): 6 ticks without an answer 120 s "
            "+ silence_secs 24 s + 2 cycles 40 s + line 8 s + turn 120 s + climb from 25 m 500 s");
}

TEST_F(WholeOf, ASkeletonWithoutTheIdleSurfaceIsAborted) {
  const std::string text = shipped("skeleton.mi");
  const auto second = text.find("behavior: surface", text.find("behavior: surface") + 5);
  const std::string twin = text.substr(0, second) + text.substr(text.find("behavior: hookbeh"));
  EXPECT_EQ(refusal(twin),
            "nothing commands heading, pitch and pump until behaviour 2 `surface` (start_when 12, "
            "when_secs 28800) starts, and the vehicle aborts");
  EXPECT_EQ(refusal(kHookbeh), "nothing commands pitch and pump, and the vehicle aborts");
}

TEST_F(WholeOf, AWrongStartCodeIsRefused) {
  for (const char* code : {"5", "7", "8", "10", "11", "13", "14", "15", "16", "17", "18", "99"}) {
    const std::string twin = replaced(shipped("skeleton.mi"), "start_when(enum)         1 ",
                                      std::string("start_when(enum) ") + code + " ");
    EXPECT_NE(refusal(twin), "") << code;
  }
  for (const char* code : {"1", "2", "3", "4"}) {
    EXPECT_DOUBLE_EQ(
        seconds(behaviour("surface", std::string("start_when(enum) ") + code) + kHookbeh),
        kLetsGo + kClimb)
        << code;
  }
}

TEST_F(WholeOf, AHeadingThatIsCommandedNeverIsIdle) {
  EXPECT_NE(refusal(behaviour("surface", "start_when(enum) 3") + kHookbeh + kHeading), "");
  EXPECT_EQ(refusal(kIdle + kHookbeh + kHeading), "");
}

TEST_F(WholeOf, AnEndlessYoBelowIsRefused) {
  const std::string yo = kHeading + behaviour("yo", "end_action(enum) 0");
  EXPECT_EQ(refusal(kIdle + kHookbeh + yo),
            "behaviour 4 `yo` (num_half_cycles_to_do -1) flies on without an end");
  const std::string again =
      kHeading + behaviour("yo", "num_half_cycles_to_do(nodim) 4,end_action(enum) 2");
  EXPECT_EQ(refusal(kIdle + kHookbeh + again),
            "behaviour 4 `yo` (end_action 2) flies on without an end");
  EXPECT_EQ(refusal(kIdle + kHookbeh + behaviour("yo", "start_when(enum) 5,end_action(enum) 0")),
            "");
}

/// It dives, but comes up for the surface behaviour above it.
TEST_F(WholeOf, AnEndlessYoSurfacesWhenATimeIsOver) {
  const std::string yo = kHeading + behaviour("yo", "d_target_depth(m) 40");
  for (const char* code : {"6", "9", "12"}) {
    const std::string timed =
        behaviour("surface", std::string("start_when(enum) ") + code + ",when_secs(s) 3600");
    EXPECT_DOUBLE_EQ(seconds(timed + kHookbeh + yo), kLetsGo + 3600 + 20 + 120 + 45 / 0.05) << code;
    EXPECT_NE(refusal(kHookbeh + yo + timed), "") << code;
  }
  EXPECT_NE(refusal(behaviour("surface", "when_secs(s) 1000000") + kHookbeh + yo), "");
}

/// What commands the slots until the surface behaviour starts must do so without an end.
TEST_F(WholeOf, AStackThatIsIdleBeforeTheTimeIsOverIsRefused) {
  const std::string timed = behaviour("surface", "start_when(enum) 12,when_secs(s) 3600");
  const std::string starts =
      " until behaviour 1 `surface` (start_when 12, when_secs 3600) starts, and the vehicle aborts";
  EXPECT_EQ(refusal(timed + kHookbeh + behaviour("yo", "")), "nothing commands heading" + starts);
  EXPECT_EQ(refusal(timed + kHookbeh + kHeading), "nothing commands pitch and pump" + starts);
  EXPECT_EQ(refusal(timed + kHookbeh), "nothing commands heading, pitch and pump" + starts);
  const std::string open_drive = "nothing is sure to command pitch and pump" + starts + ": ";
  EXPECT_EQ(refusal(timed + kHookbeh + behaviour("yo", "start_when(enum) 8") + kHeading),
            open_drive + "behaviour 3 `yo` has start_when 8");
  EXPECT_EQ(
      refusal(
          timed +
          behaviour("climb_to",
                    "end_action(enum) 2,target_depth(m) 10,use_pitch(enum) 3,pitch_value(X) 0.45") +
          kHookbeh + kHeading),
      open_drive + "behaviour 2 `climb_to` has target_depth 10");
  EXPECT_EQ(refusal(timed + kHookbeh + kHeading + behaviour("drift_at_depth", "")),
            open_drive + "behaviour 4 `drift_at_depth` has stop_when_hover_for 3600");
  for (const char* argument : {"stop_when(enum) 9", "num_half_cycles_to_do(nodim) 4"}) {
    EXPECT_NE(refusal(timed + kHookbeh + kHeading + behaviour("yo", argument)), "") << argument;
  }
}

TEST_F(WholeOf, AnySlotMayBeCommandedByAnyBehaviourWithoutAnEnd) {
  const std::string timed = behaviour("surface", "start_when(enum) 12,when_secs(s) 3600");
  const auto heading = [&](const std::string& name, const std::string& arguments) {
    return refusal(timed + kHookbeh + behaviour("yo", "") + behaviour(name, arguments));
  };
  for (const char* code : {"0", "1", "2", "3", "4"}) {
    const std::string start = std::string("start_when(enum) ") + code;
    EXPECT_EQ(heading("set_heading", "use_heading(bool) 1,heading_value(X) 1," + start), "")
        << code;
    EXPECT_EQ(refusal(timed + kHookbeh + behaviour("yo", start) + kHeading) == "", code[0] != '3')
        << code;
  }
  EXPECT_NE(heading("set_heading", "use_heading(bool) 1,heading_value(X) 1,start_when(enum) 6"),
            "");
  EXPECT_NE(heading("set_heading", "use_heading(bool) 1,heading_value(X) 1,stop_when(enum) 6"), "");
  EXPECT_NE(
      heading("set_heading", "use_heading(bool) 1,heading_value(X) 1,stop_when(enum) 1000003"), "");
  EXPECT_EQ(heading("goto_wpt", "wpt_x(X) 1,wpt_y(X) 1,stop_when(enum) 5"), "");
  EXPECT_NE(heading("goto_wpt", "wpt_x(X) 1,wpt_y(X) 1,stop_when(enum) 7"), "");
  EXPECT_EQ(heading("goto_list", "num_waypoints(nodim) 1"), "");
  EXPECT_NE(heading("goto_list", "num_waypoints(nodim) 0"), "") << "none";
  EXPECT_NE(heading("goto_list", "num_waypoints(nodim) 1,num_legs_to_run(nodim) -2"), "");
  EXPECT_EQ(heading("nop_cmds", "nop_heading(bool) 1"), "");
  EXPECT_NE(heading("nop_cmds", "nop_heading(bool) 0"), "");
  EXPECT_NE(heading("nop_cmds", "nop_heading(bool) 1,secs_to_run(s) 60"), "");
  // Above a yo, pitch is commanded already.
  EXPECT_NE(refusal(timed + kHookbeh +
                    behaviour("set_heading",
                              "use_heading(bool) 1,heading_value(X) 1,start_when(enum) 2") +
                    behaviour("yo", "")),
            "");
}

/// A behaviour that surfaces as soon as a slot is idle leaves none without a command.
TEST_F(WholeOf, AnIdleSurfaceCommandsWhatNothingElseDoes) {
  const std::string timed = behaviour("surface", "start_when(enum) 12,when_secs(s) 3600");
  EXPECT_EQ(refusal(timed + kIdle + kHookbeh + behaviour("yo", "")), "");
  EXPECT_EQ(refusal(timed + kHookbeh + kIdle), "") << "also from below";
  EXPECT_EQ(refusal(behaviour("surface", "start_when(enum) 0") + kHookbeh), "");
  EXPECT_EQ(refusal(behaviour("surface", "start_when(enum) 9,when_secs(s) 0") + kHookbeh), "");
  EXPECT_NE(refusal(behaviour("surface", "start_when(enum) 9,when_secs(s) 60") + kHookbeh), "");
  EXPECT_NE(refusal(behaviour("surface", "start_when(enum) 12,when_secs(s) 0") + kHookbeh), "")
      << "not while there is contact";
  // One that waits for pitch or pump does not see that the heading is idle.
  for (const char* code : {"2", "4"}) {
    const std::string surface = behaviour("surface", std::string("start_when(enum) ") + code);
    EXPECT_NE(refusal(surface + kHookbeh +
                      behaviour("dive_to", "use_pitch(enum) 3,pitch_value(X) -0.45")),
              "")
        << code;
    EXPECT_EQ(refusal(surface + kHookbeh + kHeading +
                      behaviour("dive_to", "use_pitch(enum) 3,pitch_value(X) -0.45")),
              "")
        << code;
    EXPECT_EQ(refusal(surface + kHookbeh + behaviour("prepare_to_dive", "")), "") << code;
  }
}

TEST_F(WholeOf, WhatAnAbortEndsSoonerIsRefused) {
  const std::string timed = behaviour("surface", "start_when(enum) 12,when_secs(s) 3600");
  const std::string rest = timed + kHookbeh + kHeading + behaviour("yo", "");
  EXPECT_EQ(refusal(behaviour("abend", "overtime(s) 14400") + rest), "");
  EXPECT_EQ(refusal(behaviour("abend", "overtime(s) -1") + rest), "");
  EXPECT_NE(refusal(behaviour("abend", "overtime(s) 3600") + rest), "");
}

TEST_F(WholeOf, AMissionParameterInAbendIsRefused) {
  EXPECT_EQ(refusal(behaviour("abend", "overtime(s) 1000001") + kIdle + kHookbeh),
            "behaviour 1 `abend` has overtime 1000001, a mission parameter, which may change in "
            "flight");
  for (const char* argument : {"overtime", "overdepth", "undervolts", "overdepth_sample_time"}) {
    const Whole whole =
        of(behaviour("abend", std::string(argument) + "(X) 1000002") + kIdle + kHookbeh);
    EXPECT_FALSE(whole.proved()) << argument;
  }
}

TEST_F(WholeOf, DivesOfOneLegCountOnce) {
  const double leg = 120 + 25 / 0.05 + 240 + 20;
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh + kHeading +
                           behaviour("dive_to", "use_pitch(enum) 3,pitch_value(X) -0.45")),
                   kLetsGo + leg + kClimb);
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh + kHeading +
                           behaviour("climb_to", "use_pitch(enum) 3,pitch_value(X) 0.45")),
                   kLetsGo + leg + kClimb);
  // Each may interrupt the other once.
  EXPECT_DOUBLE_EQ(
      seconds(kIdle + kHookbeh + behaviour("dive_to", "use_pitch(enum) 3,pitch_value(X) -0.45") +
              behaviour("climb_to", "use_pitch(enum) 3,pitch_value(X) 0.45")),
      kLetsGo + 4 * leg + kClimb);
  // And a surface behaviour below may have to climb again.
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh +
                           behaviour("dive_to", "use_pitch(enum) 3,pitch_value(X) -0.45") + kIdle),
                   kLetsGo + 2 * leg + kClimb);
  // A yo of no half cycles flies one.
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh +
                           behaviour("yo", "num_half_cycles_to_do(nodim) 0,end_action(enum) 0")),
                   kLetsGo + leg + kClimb);
  EXPECT_NE(
      refusal(kIdle + kHookbeh +
              behaviour("dive_to", "end_action(enum) 2,use_pitch(enum) 3,pitch_value(X) -0.45")),
      "");
}

TEST_F(WholeOf, ALegThatNeverStallsIsRefused) {
  EXPECT_NE(
      refusal(kIdle + kHookbeh +
              behaviour("dive_to",
                        "stop_when_stalled_for(s) -1,use_pitch(enum) 3,pitch_value(X) -0.45")),
      "");
  EXPECT_NE(refusal(kIdle + kHookbeh +
                    behaviour("yo",
                              "num_half_cycles_to_do(nodim) 2,end_action(enum) "
                              "0,c_stop_when_stalled_for(s) -1")),
            "");
}

TEST_F(WholeOf, WhatTheArgumentsDoNotBoundIsRefused) {
  for (const char* arguments :
       {"d_target_depth(m) 1000003", "c_target_depth(m) 1000003",
        "num_half_cycles_to_do(nodim) 1000000", "c_bpump_value(X) -1000", "c_bpump_value(X) 50",
        "d_bpump_value(X) 260", "c_pitch_value(X) -0.4", "c_pitch_value(X) 0.1",
        "d_pitch_value(X) 0.4", "c_use_pitch(enum) 1", "d_use_bpump(enum) 3"}) {
    EXPECT_NE(refusal(behaviour("surface", "start_when(enum) 12,when_secs(s) 60") + kIdle +
                      kHookbeh + behaviour("yo", arguments)),
              "")
        << arguments;
  }
}

TEST_F(WholeOf, ASurfaceBehaviourThatDoesNotClimbIsRefused) {
  for (const char* argument :
       {"c_bpump_value(X) -1000", "c_bpump_value(X) 100", "c_bpump_value(X) 1000004",
        "c_use_bpump(enum) 3", "c_pitch_value(X) -0.4538", "c_pitch_value(X) 0.05",
        "c_pitch_value(X) 1.5", "c_use_pitch(enum) 1"}) {
    EXPECT_NE(
        refusal(behaviour("surface", std::string("start_when(enum) 1,") + argument) + kHookbeh), "")
        << argument;
    // Also beside one that does: it may stand above it.
    EXPECT_NE(refusal(kIdle + kHookbeh +
                      behaviour("surface", std::string("start_when(enum) 7,") + argument)),
              "")
        << argument;
  }
}

/// It chooses the volume by itself and need not use bpump_value.
TEST_F(WholeOf, AutoballastIsRefused) {
  EXPECT_EQ(refusal(behaviour("surface", "start_when(enum) 1,c_use_bpump(enum) 0") + kHookbeh),
            "behaviour 1 `surface` (c_use_bpump 0) may command anything below");
  EXPECT_NE(
      refusal(kIdle + kHookbeh +
              behaviour("dive_to", "use_bpump(enum) 0,use_pitch(enum) 3,pitch_value(X) -0.45")),
      "");
}

TEST_F(WholeOf, WhatHoldsPitchOrPumpOrIsUnknownIsRefused) {
  EXPECT_NE(refusal(kIdle + kHookbeh + behaviour("nop_cmds", "nop_pitch(bool) 1")), "");
  EXPECT_NE(refusal(kIdle + kHookbeh + behaviour("nop_cmds", "nop_bpump(bool) 1")), "");
  EXPECT_EQ(refusal(kIdle + kHookbeh + behaviour("nop_cmds", "nop_heading(bool) 1")), "");
  EXPECT_NE(refusal(kIdle + kHookbeh + behaviour("drift_at_depth", "end_action(enum) 0")), "");
  EXPECT_NE(refusal(kIdle + kHookbeh + behaviour("comatose", "")), "");
}

TEST_F(WholeOf, APreparationCountsItsWait) {
  const std::string prepare = behaviour("prepare_to_dive", "wait_time(s) 300");
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh + prepare), kLetsGo + 300 + kClimb);
  EXPECT_DOUBLE_EQ(seconds(prepare + kIdle + kHookbeh), kLetsGo + 300 + kClimb);
}

TEST_F(WholeOf, TheOrderCounts) {
  const std::string yo =
      kHeading + behaviour("yo", "num_half_cycles_to_do(nodim) 4,end_action(enum) 0");
  EXPECT_EQ(refusal(kIdle + kHookbeh + yo), "");
  EXPECT_EQ(refusal(kHookbeh + yo + kIdle),
            "behaviour 3 `yo` stands above behaviour 4 `surface` and replaces its commands");
  const Whole masked = of(yo + kIdle + kHookbeh);
  EXPECT_EQ(after(masked, "masking by behaviour 2 `yo`").why_not,
            "behaviour 2 `yo` (it dives) stands above hookbeh and replaces its commands");
  EXPECT_FALSE(of(kIdle + yo + kHookbeh).proved());
}

TEST_F(WholeOf, TheSilenceMustBeAValidTime) {
  EXPECT_DOUBLE_EQ(
      seconds(replaced(shipped("skeleton.mi"), "    b_arg: silence_secs(s)     24\n", "")),
      kLetsGo + kClimb)
      << "it is 24 s without one";
  for (const char* wrong : {"0", "-1", "3601", "1000000"}) {
    EXPECT_NE(refusal(kIdle + behaviour("hookbeh", std::string("silence_secs(s) ") + wrong)), "")
        << wrong;
  }
  EXPECT_DOUBLE_EQ(seconds(kIdle + behaviour("hookbeh", "silence_secs(s) 100")), 100 + 48 + kClimb);
}

/// The beats on behalf of an SBC that has died in its sleep count for so long.
TEST_F(WholeOf, TheNapsOfAMissionThatHasThemCount) {
  const std::string text = kIdle + behaviour("hookbeh", "nap_secs(s) 280");
  const auto seconds_of = [&](bool naps) {
    return after(of(text, kDeepest, hull(), naps), "silence of the SBC").seconds();
  };
  EXPECT_DOUBLE_EQ(seconds_of(false), kLetsGo + kClimb);
  EXPECT_DOUBLE_EQ(seconds_of(true), kLetsGo + 280 + kClimb);
}

TEST_F(WholeOf, ThereIsOneHookbeh) {
  EXPECT_FALSE(of(kIdle).proved());
  EXPECT_FALSE(of(kIdle + kHookbeh + kHookbeh).proved());
}

TEST_F(WholeOf, AVehicleThatDoesNotReadItsDepthIsRefused) {
  EXPECT_EQ(refusal(kIdle + kHookbeh + behaviour("sensors_in", "c_pressure_time(s) 4")), "");
  EXPECT_NE(refusal(kIdle + kHookbeh + behaviour("sensors_in", "c_pressure_time(s) -1")), "");
  EXPECT_NE(refusal(kIdle + kHookbeh + behaviour("sensors_in", "c_att_time(s) 60")), "");
  EXPECT_NE(refusal("sensor: c_pressure_time(s) -1\n" + kIdle + kHookbeh), "");
  EXPECT_NE(
      refusal("sensor: c_pressure_time(s) -1\n" + kIdle + kHookbeh + behaviour("sensors_in", "")),
      "")
      << "what it does not give stays";
  EXPECT_EQ(refusal("sensor: c_pressure_time(s) -1\n" + kIdle + kHookbeh +
                    behaviour("sensors_in", "c_pressure_time(s) 0")),
            "");
}

TEST_F(WholeOf, ASettingThatIsNotKnownToBeHarmlessIsRefused) {
  const std::string good = kIdle + kHookbeh;
  const Whole whole =
      of("sensor: u_reqd_depth_at_surface(m) 30\nsensor: u_adj_overshoot(bool) 1\n" + good);
  ASSERT_EQ(whole.endings.size(), 1U);
  EXPECT_EQ(whole.endings[0].after, "any loss of control");
  EXPECT_EQ(whole.endings[0].why_not,
            "what the setting u_reqd_depth_at_surface 30 does to the way to the surface is not "
            "known; nor what these do: u_adj_overshoot 1");
  EXPECT_EQ(whole.endings[0].change, "delete its line `sensor:`, or give it a value of at most 2");
  EXPECT_TRUE(whole.endings[0].range.valid());
  for (const char* bad :
       {"u_cycle_time(sec) 60", "u_cycle_time(sec) 1000001", "c_ballast_pumped(cc) 1",
        "u_use_ctd_depth_for_flying(bool) 1", "f_max_working_depth(m) 10",
        "u_mission_parameter(X) 1", "u_mission_param_aa(X) 1"}) {
    EXPECT_FALSE(of("sensor: " + std::string(bad) + "\n" + good).proved()) << bad;
  }
  for (const char* harmless :
       {"u_reqd_depth_at_surface(m) 2", "u_cycle_time(sec) 4", "u_use_current_correction(nodim) 1",
        "u_mission_param_a(X) 5", "u_mission_mode(X) 3", "c_alt_time(sec) 8",
        "u_alt_reduced_usage_mode(bool) 1", "c_science_all_on_enabled(bool) 0",
        "c_profile_on(sec) 4", "u_dbd_sensor_list_xmit_control(enum) 0"}) {
    EXPECT_TRUE(of("sensor: " + std::string(harmless) + "\n" + good).proved()) << harmless;
  }
}

/// The vehicle's calibration is in it, and what the mission file sets itself does not count there.
TEST_F(WholeOf, TheSettingsOfTheVehicleCountToo) {
  const std::string good = kIdle + kHookbeh;
  (void)folder_.write("autoexec.mi", "sensor: f_max_working_depth(m) 98\n");
  EXPECT_TRUE(of(good).proved());
  (void)folder_.write("autoexec.mi", "sensor: u_cycle_time(sec) 60\n");
  EXPECT_FALSE(of(good).proved());
  EXPECT_TRUE(of("sensor: u_cycle_time(sec) 4\n" + good).proved());
}

TEST_F(WholeOf, LimitsThatAreOffAbortNothing) {
  const Whole whole =
      of(behaviour("abend", "overdepth(m) -1,undervolts(volts) -1") + kIdle + kHookbeh);
  EXPECT_EQ(std::ranges::count_if(whole.endings,
                                  [](const Ending& ending) {
                                    return ending.after.find("undervolts") != std::string::npos ||
                                           ending.after.find("overdepth") != std::string::npos ||
                                           ending.after.find("check_emergency") !=
                                               std::string::npos;
                                  }),
            0);
  EXPECT_NE(after(whole, "an abort").after.find("samedepth_for 1800"), std::string::npos);
}

}  // namespace
}  // namespace glider::slocum::rules
