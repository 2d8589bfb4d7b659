// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is proved about the vehicle's own mission file after control ends: the bundled files with
// their times, and twins of them with a fault each, which are refused.

#include "analysis/analysis.h"
#include "slocum/mission_files/load.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace glider::analysis {
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
  return platform;
}

constexpr double kDeepest = 25;       // m, of the mission's commands
constexpr double kLetsGo = 24 + 40;   // s: silence_secs and two cycles
constexpr double kUnanswered = 120;   // s: six ticks
constexpr double kClimb = 120 + 500;  // s, from 25 m

class WholeOf : public ::testing::Test {
 protected:
  [[nodiscard]] Whole ofFile(const std::string& path, double deepest_m = kDeepest) const {
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    const auto mission = slocum::loadMission(path, sources, diagnostics, [](auto&&...) {});
    EXPECT_TRUE(mission) << path;
    return mission ? wholeOf(*mission, hull(), deepest_m) : Whole{};
  }
  [[nodiscard]] Whole of(const std::string& text, double deepest_m = kDeepest) const {
    return ofFile(folder_.write("a.mi", text).string(), deepest_m);
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
const std::string kHeading = behaviour("set_heading", "heading_value(X) 1");

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
  EXPECT_EQ(of(kIdle + kHookbeh + behaviour("dive_to", "target_depth(m) 70")).deepest_m, 75);
  EXPECT_EQ(of(kIdle + kHookbeh + behaviour("climb_to", "target_depth(m) 70")).deepest_m, 25);
}

TEST_F(WholeOf, TheLinesNameTheBehaviourTheTimeAndItsParts) {
  const auto lines = wholeLines(of(shipped("skeleton.mi")));
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0],
            "after `exit`, instructions that get no answer the vehicle is at the surface within "
            "13 min 24 s, by behaviour 3 `surface` (start_when 1): 6 ticks without an answer 120 s "
            "+ silence_secs 24 s + 2 cycles 40 s + turn 120 s + climb from 25 m 500 s");
}

TEST_F(WholeOf, ASkeletonWithoutTheIdleSurfaceIsAborted) {
  const std::string text = shipped("skeleton.mi");
  const auto second = text.find("behavior: surface", text.find("behavior: surface") + 5);
  const std::string twin = text.substr(0, second) + text.substr(text.find("behavior: hookbeh"));
  EXPECT_EQ(refusal(twin),
            "behaviour 2 `surface` (start_when 12, when_secs 28800) does not start when it should: "
            "nothing commands pitch and pump, and the vehicle aborts");
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

TEST_F(WholeOf, WhatAnAbortEndsSoonerIsRefused) {
  const std::string timed = behaviour("surface", "start_when(enum) 12,when_secs(s) 3600");
  const std::string rest = timed + kHookbeh + kHeading + behaviour("yo", "");
  EXPECT_EQ(refusal(behaviour("abend", "overtime(s) 14400") + rest), "");
  EXPECT_EQ(refusal(behaviour("abend", "overtime(s) -1") + rest), "");
  EXPECT_NE(refusal(behaviour("abend", "overtime(s) 3600") + rest), "");
}

TEST_F(WholeOf, DivesOfOneLegCountOnce) {
  const double leg = 120 + 25 / 0.05 + 240 + 20;
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh + kHeading + behaviour("dive_to", "")),
                   kLetsGo + leg + kClimb);
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh + kHeading + behaviour("climb_to", "")),
                   kLetsGo + leg + kClimb);
  // Each may interrupt the other once.
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh + behaviour("dive_to", "") + behaviour("climb_to", "")),
                   kLetsGo + 4 * leg + kClimb);
  // And a surface behaviour below may have to climb again.
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh + behaviour("dive_to", "") + kIdle),
                   kLetsGo + 2 * leg + kClimb);
  // A yo of no half cycles flies one.
  EXPECT_DOUBLE_EQ(seconds(kIdle + kHookbeh +
                           behaviour("yo", "num_half_cycles_to_do(nodim) 0,end_action(enum) 0")),
                   kLetsGo + leg + kClimb);
  EXPECT_NE(refusal(kIdle + kHookbeh + behaviour("dive_to", "end_action(enum) 2")), "");
}

TEST_F(WholeOf, ALegThatNeverStallsIsRefused) {
  EXPECT_NE(refusal(kIdle + kHookbeh + behaviour("dive_to", "stop_when_stalled_for(s) -1")), "");
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
  EXPECT_EQ(refusal(behaviour("surface", "start_when(enum) 1,c_use_bpump(enum) 0") + kHookbeh), "");
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
  EXPECT_DOUBLE_EQ(seconds(kIdle + behaviour("hookbeh", "silence_secs(s) 100")), 100 + 40 + kClimb);
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
  EXPECT_EQ(
      refusal("sensor: c_pressure_time(s) -1\n" + kIdle + kHookbeh + behaviour("sensors_in", "")),
      "");
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
}  // namespace glider::analysis
