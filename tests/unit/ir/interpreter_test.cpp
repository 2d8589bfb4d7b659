// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/eval/interpreter.h"

#include "tests/unit/ir/missions.h"

#include <limits>

namespace glider::ir {
namespace {

constexpr SensorId kDepthSensor{0}, kTemp{1};
constexpr double kUnknownValue = std::numeric_limits<double>::quiet_NaN();

using Updates = std::vector<SensorUpdate>;

/// The call of the profile in this tick.
ActivityRun runOf(const TickResult& result, ListKind list = ListKind::Profile) {
  for (const Action& action : result.actions) {
    const auto* run = std::get_if<ActivityRun>(&action);
    if (run != nullptr && run->list == list) {
      return *run;
    }
  }
  ADD_FAILURE() << "it was not called";
  return {};
}

TickResult tick(Interpreter& i, double time, const Updates& frame = {}) {
  return i.tick(time, frame);
}

TEST(Interpreter, FliesFigure2) {
  const Mission m = missionOf(
      kHeader +
      stateText("s1",
                "case (ge missiontime 2000:time) goto s3 "
                "case (and (ge missiontime 500:time) (lt missiontime 1500:time)) call s2") +
      stateText("s2", "case (ge missiontime 1500:time) return") +
      stateText("s3", "case (ge missiontime 2500:time) exit"));
  Interpreter i(m, 1);
  EXPECT_EQ(i.start().state.index, 0u);
  std::vector<std::pair<double, uint32_t>> changes;
  uint32_t state = 0;
  double time = 4;
  for (; time < 3000; time += 4) {
    const TickResult r = tick(i, time);
    if (r.state.index != state) {
      changes.emplace_back(time, state = r.state.index);
    }
    EXPECT_EQ(r.stack.size(), state == 1 ? 1u : 0u);
    if (r.finished) {
      break;
    }
  }
  EXPECT_EQ(changes, (std::vector<std::pair<double, uint32_t>>{{500, 1}, {1500, 0}, {2000, 2}}));
  EXPECT_EQ(time, 2500);
}

TEST(Interpreter, TellsClocksApart) {
  const Mission m =
      missionOf(kHeader +
                "state a route drift () profile to (1:length, statetime) log r every 0 resumetime "
                "case (eq missiontime 4:time) call b case (eq missiontime 16:time) goto a "
                "state b route drift () profile to (2:length, statetime) log r every 0 resumetime "
                "case (ge statetime 4:time) return");
  Interpreter i(m, 1);
  const ExprId clock_a = m.states[0].log[0].value, clock_b = m.states[1].log[0].value;
  EXPECT_EQ(runOf(i.start()).phase, Phase::Enter);
  TickResult r = tick(i, 4);  // a calls b
  EXPECT_EQ(r.firedIn(ListKind::State), 0u);
  EXPECT_EQ(runOf(r).phase, Phase::Enter);
  EXPECT_EQ(runOf(r).arguments, (std::vector<double>{2, 0}));
  EXPECT_EQ(r.stack.at(0).entered, 0);
  r = tick(i, 6);
  EXPECT_EQ(r.firedIn(ListKind::State), std::nullopt);
  EXPECT_EQ(runOf(r).phase, Phase::Tick);
  EXPECT_EQ(i.number(clock_b), 2);
  r = tick(i, 8);  // back in a: its time runs on, its resume time restarts
  EXPECT_EQ(r.state.index, 0u);
  EXPECT_EQ(runOf(r).phase, Phase::Resume);
  EXPECT_EQ(runOf(r, ListKind::Route).phase, Phase::Resume);
  EXPECT_EQ(runOf(r).arguments, (std::vector<double>{1, 8}));
  EXPECT_EQ(i.number(clock_a), 0);
  tick(i, 12);
  EXPECT_EQ(i.number(clock_a), 4);
  r = tick(i, 16);  // goto itself enters it again
  EXPECT_EQ(runOf(r).phase, Phase::Enter);
  EXPECT_EQ(runOf(r).arguments.at(1), 0);
}

TEST(Interpreter, TriesGuardsOnTheTickAfterTheEntry) {
  const Mission m =
      missionOf(kHeader + stateText("a", "case true goto b") + stateText("b", "case true exit"));
  Interpreter i(m, 0);
  EXPECT_EQ(i.start().state.index, 0u);
  EXPECT_EQ(tick(i, 4).state.index, 1u);
  const TickResult last = tick(i, 8);
  EXPECT_TRUE(last.finished);
  EXPECT_EQ(last.firedIn(ListKind::State), 0u);
  EXPECT_TRUE(last.actions.empty());
  const TickResult after = tick(i, 12);
  EXPECT_TRUE(after.finished);
  EXPECT_EQ(after.firedIn(ListKind::State), std::nullopt);
  EXPECT_EQ(after.state.index, 1u);
}

TEST(Interpreter, TakesTheFirstTrueCaseAndStayEndsTheList) {
  const Mission m = missionOf(kHeader +
                              stateText("a",
                                        "case (gt (sensor temp) 5:temperature) stay "
                                        "case (gt (sensor depth) 5:length) goto b case true stay") +
                              stateText("b", ""));
  Interpreter i(m, 0);
  i.start();
  EXPECT_EQ(tick(i, 4, {{kTemp, 9}, {kDepthSensor, 9}}).firedIn(ListKind::State), 0u);
  EXPECT_EQ(tick(i, 8, {{kTemp, 1}, {kDepthSensor, 1}}).firedIn(ListKind::State), 2u);
  const TickResult r = tick(i, 12, {{kDepthSensor, 9}});
  EXPECT_EQ(r.firedIn(ListKind::State), 1u);
  EXPECT_EQ(r.state.index, 1u);
}

TEST(Interpreter, UnknownSilencesAGuardAndItsOpposite) {
  const Mission m =
      missionOf(kHeader + stateText("a",
                                    "case (gt (sensor temp) 5:temperature) exit "
                                    "case (not (gt (sensor temp) 5:temperature)) exit "
                                    "case (not (known (sensor temp))) stay"));
  Interpreter i(m, 0);
  i.start();
  EXPECT_EQ(tick(i, 4).firedIn(ListKind::State), 2u) << "never seen";
  EXPECT_EQ(tick(i, 8, {{kTemp, kUnknownValue}}).firedIn(ListKind::State), 2u);
  EXPECT_EQ(tick(i, 12, {{kTemp, 41}}).firedIn(ListKind::State), 2u) << "beyond its range";
  EXPECT_EQ(tick(i, 16, {{kTemp, 3}}).firedIn(ListKind::State), 1u);
}

TEST(Interpreter, ReadingsAgeAndGoStale) {
  const Mission m = missionOf(
      kHeader + "state a route drift () profile to ((sensor depth), (age depth)) case false exit");
  Interpreter i(m, 0);
  TickResult r = i.start();
  EXPECT_NE(runOf(r).arguments[0], runOf(r).arguments[0]);
  EXPECT_EQ(runOf(tick(i, 8)).arguments[1], 8) << "of one never seen, since mission time 0";
  EXPECT_EQ(runOf(tick(i, 10, {{kDepthSensor, 7}})).arguments, (std::vector<double>{7, 0}));
  EXPECT_EQ(runOf(tick(i, 30)).arguments, (std::vector<double>{7, 20}));
  r = tick(i, 31);
  EXPECT_NE(runOf(r).arguments[0], runOf(r).arguments[0]) << "stale after 20 s";
  EXPECT_EQ(runOf(r).arguments[1], 21);
  r = tick(i, 40, {{kDepthSensor, kUnknownValue}});
  EXPECT_NE(runOf(r).arguments[0], runOf(r).arguments[0]);
  EXPECT_EQ(runOf(r).arguments[1], 0) << "a frame held it, if only as NaN";
  EXPECT_EQ(runOf(tick(i, 44, {{kDepthSensor, 1}, {kDepthSensor, 2}})).arguments[0], 2);
}

TEST(Interpreter, MissionTimeNeverGoesBack) {
  const Mission m = missionOf(
      kHeader + "state a route drift () profile to (1:length, missiontime) case false exit");
  Interpreter i(m, 0);
  i.start();
  EXPECT_EQ(runOf(tick(i, 8)).arguments[1], 8);
  EXPECT_EQ(runOf(tick(i, 4, {{kDepthSensor, 1}})).arguments[1], 8);
  EXPECT_EQ(runOf(tick(i, 12)).arguments[1], 12);
}

TEST(InterpreterDeathTest, RefusesWhatVerificationRulesOut) {
  const Mission m = missionOf(kHeader + stateText("a", "case true return"));
  Interpreter i(m, 0);
  i.start();
  EXPECT_DEATH(tick(i, 4), "nowhere to go");
  const Mission n = missionOf(kHeader + stateText("a", "case true call b") + stateText("b", ""));
  Interpreter k(n, 0);
  k.start();
  EXPECT_DEATH(tick(k, 4), "deeper than");
}

/// The operand and the number after `where` have different places in different windows.
TEST(Interpreter, WindowsOverALegThatComputeFromTwoNumbers) {
  constexpr SensorId kPhase{2};
  const std::pair<const char*, double> rows[] = {
      {"at_lowest always (sensor depth) where (sensor temp)", 9},
      {"at_highest always (sensor depth) where (sensor temp)", 0},
      {"steepest always (sensor temp) where (sensor depth)", -2},
      {"at_steepest always (sensor depth) where (sensor temp)", 4.5}};
  for (const auto& [window, value] : rows) {
    const Mission m = missionOf(
        kHeader +
        "sensor doing: number vehicle m_depth_state id 3 encoding linear to_si 1 lowest 0 highest "
        "99 stale_after 20\ntemporal " +
        window + " over this 1 2 along (sensor doing)\n" +
        "state a route drift () profile glide () case (known (temporal 0)) stay\n");
    Interpreter i(m, 0);
    i.start();
    tick(i, 4, {{kPhase, 0}});
    double time = 8;
    for (const auto& [depth, temp] : {std::pair(0.0, 20.0), {3, 20}, {6, 14}, {9, 13}}) {
      tick(i, time, {{kPhase, 1}, {kDepthSensor, depth}, {kTemp, temp}});
      time += 4;
    }
    tick(i, time, {{kPhase, 0}});
    EXPECT_EQ(i.number(m[m.states[0].cases[0].guard].operands[0]), value) << window;
  }
}

}  // namespace
}  // namespace glider::ir
