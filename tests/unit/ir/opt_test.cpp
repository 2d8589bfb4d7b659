// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the passes must leave alone: calls that nothing reads, windows that differ in one thing,
// sensors that something reads.

#include "ir/core/monitor_writer.h"
#include "ir/core/validate.h"
#include "ir/opt/optimise.h"
#include "ir/opt/passes.h"
#include "ir/opt/prepare_for_flight.h"
#include "tests/unit/ir/missions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glider::ir {
namespace {

const std::string kFunctions =
    "function f symbol f (x: length): bool lowest -inf highest inf\n"
    "function g symbol g (): bool lowest -inf highest inf\n";

/// How many expressions and watched things are left after all passes.
Mission optimised(const std::string& text) {
  return optimise(missionOf(kHeader + text));
}

size_t callsIn(const Mission& mission) {
  return static_cast<size_t>(std::ranges::count(mission.exprs, Op::Call, &Expr::op));
}

/// Without one of them a mission flies the same, only larger and slower: nothing else would tell.
TEST(Optimise, RunsEveryPass) {
  std::string cases = "case false exit ";
  for (int i = 0; i < 16; ++i) {
    cases += "case (ge (sensor depth) (add " + std::to_string(i) + ":length 1:length)) stay ";
  }
  const Mission m = optimised(stateText("a", cases) + stateText("never", "case true exit"));
  EXPECT_EQ(std::ranges::count(m.exprs, Op::Add, &Expr::op), 0) << "fold-constants";
  EXPECT_EQ(std::ranges::count(m.states.at(0).cases, Transition::Exit, &Case::transition), 0)
      << "drop-dead-cases";
  EXPECT_EQ(m.states.size(), 1U) << "drop-dead-states";
  EXPECT_EQ(std::ranges::count(m.exprs, Op::Sensor, &Expr::op), 1) << "share-expressions";
  EXPECT_EQ(m.states.at(0).table.rows.size(), 16U) << "tabulate-guards";
}

TEST(FoldConstants, ACallIsMadeEvenIfItsResultIsKnown) {
  for (const char* guard :
       {"(and false (call 0 (sensor depth)))", "(and (call 0 (sensor depth)) false)",
        "(or true (call 0 (sensor depth)))", "(or (call 0 (sensor depth)) true)",
        "(and false (not (call 0 (sensor depth))))"}) {
    const Mission m =
        optimised(kFunctions + "use f " + stateText("a", std::string("case ") + guard + " stay"));
    EXPECT_EQ(callsIn(m), 1U) << guard;
  }
  for (const char* guard :
       {"(and false (gt (sensor depth) 5:length))", "(and (gt (sensor depth) 5:length) false)"}) {
    const Mission m = optimised(stateText("a", std::string("case ") + guard + " exit"));
    EXPECT_EQ(std::ranges::count(m.exprs, Op::Greater, &Expr::op), 0) << guard;
  }
}

TEST(FoldConstants, NeutralSidesGoAndTheOtherStays) {
  for (const char* guard :
       {"(and true (gt (sensor depth) 5:length))", "(and (gt (sensor depth) 5:length) true)",
        "(or false (gt (sensor depth) 5:length))", "(or (gt (sensor depth) 5:length) false)",
        "(not (not (gt (sensor depth) 5:length)))"}) {
    Mission m = missionOf(kHeader + stateText("a", std::string("case ") + guard + " exit"));
    opt::foldConstants(m);
    EXPECT_EQ(m[m.states[0].cases.at(0).guard].op, Op::Greater) << guard;
  }
}

TEST(FoldConstants, EvaluatesWhatIsKnown) {
  struct Row {
    const char* text;
    double number;
  };
  for (const Row& row : {Row{"(add 2:length 3:length)", 5}, Row{"(sub 2:length 3:length)", -1},
                         Row{"(min 2:length 3:length)", 2}, Row{"(max 2:length 3:length)", 3},
                         Row{"(neg 2:length)", -2}, Row{"(abs -2:length)", 2},
                         Row{"(clamp 7:length 2:length 3:length)", 3}}) {
    Mission m =
        missionOf(kHeader + "variable x: length mission initial x 0:length " +
                  stateText("a", std::string("case true do set x ") + row.text + " end exit"));
    opt::foldConstants(m);
    const Statement& set = m.blocks.at(0).statements.at(0);
    EXPECT_EQ(m[set.value].op, Op::Constant) << row.text;
    EXPECT_EQ(m[set.value].number, row.number) << row.text;
  }
  for (const char* text : {"(gt 3:length 2:length)", "(ge 2:length 2:length)",
                           "(ne 3:length 2:length)", "(known 3:length)"}) {
    Mission m = missionOf(kHeader + stateText("a", std::string("case ") + text + " exit"));
    opt::foldConstants(m);
    EXPECT_EQ(m[m.states[0].cases.at(0).guard].op, Op::True) << text;
  }
  for (const char* text : {"(lt 3:length 2:length)", "(gt 2:length 2:length)",
                           "(eq 3:length 2:length)", "(not true)"}) {
    Mission m = missionOf(kHeader + stateText("a", std::string("case ") + text + " exit"));
    opt::foldConstants(m);
    EXPECT_EQ(m[m.states[0].cases.at(0).guard].op, Op::False) << text;
  }
}

TEST(FoldConstants, WhatHasNoValueStays) {
  for (const char* text : {"(sqrt -1)", "(div 1 0)", "(mul 1e300 1e300)", "(element 0 2)"}) {
    Mission m = missionOf(kHeader + "table number (4, 5)\nvariable x: number mission initial x 0 " +
                          stateText("a", std::string("case true do set x ") + text + " end exit"));
    opt::foldConstants(m);
    EXPECT_NE(m[m.blocks.at(0).statements.at(0).value].op, Op::Constant) << text;
  }
}

TEST(ShareExpressions, WhatDiffersInOneThingStaysTwo) {
  // How many expressions are left of two numbers that are compared with 1.
  const auto left = [](const std::string& one, const std::string& two) {
    Mission m =
        missionOf(kHeader +
                  "table number (4, 5)\ntable number (4, 6)\n"
                  "variable x: number mission\nvariable y: number mission\n"
                  "initial x 0\ninitial y 0\n" +
                  stateText("a", "case (gt " + one + " 1) stay case (gt " + two + " 1) exit"));
    opt::shareExpressions(m);
    return m.states[0].cases.at(0).guard == m.states[0].cases.at(1).guard ? 1 : 2;
  };
  EXPECT_EQ(left("(add (var x) 2)", "(add (var x) 2)"), 1);
  EXPECT_EQ(left("(add (var x) 2)", "(sub (var x) 2)"), 2);
  EXPECT_EQ(left("(add (var x) 2)", "(add (var x) 3)"), 2);
  EXPECT_EQ(left("(add (var x) 2)", "(add 2 (var x))"), 2);
  EXPECT_EQ(left("(var x)", "(var y)"), 2);
  EXPECT_EQ(left("(element 0 (var x))", "(element 1 (var x))"), 2);
  EXPECT_EQ(left("(element 0 (var x))", "(element 0 (var x))"), 1);
  EXPECT_EQ(left("(div (sensor depth) 1:length)", "(div (sensor temp) 1:temperature)"), 2);
}

TEST(DropDeadStates, KeepsThoseToWhichSomeCaseLeads) {
  const auto names = [](const std::string& text) {
    Mission m = missionOf(kHeader + text);
    opt::dropDeadStates(m);
    std::string all;
    for (const State& state : m.states) {
      all += state.name;
    }
    return all;
  };
  const std::string rest = stateText("c", "case true goto d") + stateText("d", "case true exit");
  EXPECT_EQ(names(stateText("a", "case true exit") + stateText("b", "case true goto a") + rest),
            "a");
  EXPECT_EQ(names(stateText("a", "case true goto b") + stateText("b", "case true exit") + rest),
            "ab");
  EXPECT_EQ(names(stateText("a", "case true call c") + stateText("b", "case true exit") + rest),
            "acd");
  EXPECT_EQ(names("always case (gt (sensor depth) 5:length) goto b\n" +
                  stateText("a", "case true exit") + stateText("b", "case true exit") + rest),
            "ab");
}

TEST(DropDeadStates, MonitorsFollowTheirVariables) {
  Mission m =
      missionOf(kHeader + "variable n: bool state of never\n" + stateText("a", "case true exit") +
                "state never initial n true route drift () profile glide () case (var n) exit\n");
  MonitorWriter monitor(m, "promise 1", {});
  monitor.violation(monitor.observed(ObservationKind::Entered, {0}), "`a` was entered");
  monitor.finish(m.requirements.emplace_back());
  opt::dropDeadStates(m);
  ASSERT_EQ(m.states.size(), 1U);
  const VariableId seen = m.requirements[0].monitor.observations.at(0).variable;
  EXPECT_EQ(m[seen].name, "promise 1.1.entered");
  EXPECT_TRUE(validate(m).empty());
}

TEST(DropDeadCases, WhatFollowsATrueOneIsRemoved) {
  const auto left = [](const std::string& cases, const std::string& always = "") {
    Mission m =
        missionOf(kHeader + always + stateText("a", cases) + stateText("b", "case true exit"));
    opt::dropDeadCases(m);
    return std::pair(m.always.size(), m.states[0].cases.size());
  };
  using Left = std::pair<size_t, size_t>;
  const std::string deep = "case (gt (sensor depth) 5:length) stay ";
  EXPECT_EQ(left(deep + "case true exit " + deep), Left(0, 2));
  EXPECT_EQ(left("case true exit " + deep + deep), Left(0, 1));
  EXPECT_EQ(left(deep + "case false exit " + deep), Left(0, 3)) << "numbers stay as they are";
  EXPECT_EQ(left(deep + "case false exit case false exit"), Left(0, 1));
  EXPECT_EQ(left(deep, "always case true goto b " + deep + "\n"), Left(2, 1))
      << "may be passed over";
}

TEST(Compact, WatchedCallsThatNothingReadsAreStillMade) {
  for (const char* watched : {"temporal held always (call 0 (sensor depth)) for 8:time ",
                              "temporal became always (call 0 (sensor depth)) "}) {
    const Mission m = optimised(kFunctions + "use f " + watched + stateText("a", "case true stay"));
    EXPECT_EQ(callsIn(m), 1U) << watched;
    EXPECT_EQ(m.temporals.size(), 1U) << watched;
  }
  const Mission of_state = optimised(kFunctions + "use f " +
                                     "state a route drift () profile glide () "
                                     "temporal became state a (call 0 (sensor depth)) "
                                     "case true stay\n");
  EXPECT_EQ(callsIn(of_state), 1U);
  const Mission plain = optimised("temporal held always (gt (sensor depth) 3:length) for 8:time " +
                                  stateText("a", "case true stay"));
  EXPECT_EQ(plain.temporals.size(), 0U) << "what calls nothing and is not read goes";
}

/// Two windows of the same text except for `one` and `two`: how many are left.
size_t windowsOf(const std::string& one, const std::string& two) {
  const Mission m = optimised(
      "temporal " + one + "\ntemporal " + two + "\n" +
      stateText("a", "case (gt (temporal 0) 5:length) stay case (gt (temporal 1) 7:length) exit"));
  return m.temporals.size();
}

TEST(ShareExpressions, WindowsThatDifferInOneThingStayTwo) {
  const std::string window = "mean always (sensor depth) over 10";
  EXPECT_EQ(windowsOf(window, window), 1U);
  EXPECT_EQ(windowsOf(window, "mean always (sensor depth) over 11"), 2U);
  EXPECT_EQ(windowsOf(window, "lowest always (sensor depth) over 10"), 2U);
  EXPECT_EQ(windowsOf(window, "mean always (add (sensor depth) 1:length) over 10"), 2U);
  EXPECT_EQ(windowsOf(window, window + " along (sensor depth)"), 2U);
  EXPECT_EQ(windowsOf(window + " along (sensor temp)", window + " along (sensor depth)"), 2U);
  EXPECT_EQ(windowsOf(window + " along (sensor temp)", window + " along (sensor temp)"), 1U);
}

TEST(ShareExpressions, GuardsThatAreHeldForDifferentTimesStayTwo) {
  const auto held = [](const std::string& one, const std::string& two) {
    const Mission m = optimised("temporal " + one + "\ntemporal " + two + "\n" +
                                stateText("a", "case (temporal 0) stay case (temporal 1) exit"));
    return m.temporals.size();
  };
  const std::string deep = "held always (gt (sensor depth) 5:length)";
  EXPECT_EQ(held(deep + " for 8:time", deep + " for 8:time"), 1U);
  EXPECT_EQ(held(deep + " for 8:time", deep + " for 9:time"), 2U);
  EXPECT_EQ(held("became always (gt (sensor depth) 5:length)", deep + " for 8:time"), 2U);
}

TEST(ShareExpressions, EqualExpressionsAreOneAndCallsAreNot) {
  Mission m = missionOf(kHeader + kFunctions + "use g use g " +
                        stateText("a",
                                  "case (and (gt (sensor depth) 5:length) (call 0)) stay "
                                  "case (and (gt (sensor depth) 5:length) (call 1)) exit"));
  opt::shareExpressions(m);
  EXPECT_EQ(std::ranges::count(m.exprs, Op::Greater, &Expr::op), 1);
  EXPECT_EQ(callsIn(m), 2U);
}

/// The names of the sensors that are left.
std::vector<std::string> sensorsOf(const Mission& mission) {
  std::vector<std::string> names;
  for (const Sensor& sensor : mission.sensors) {
    names.push_back(sensor.name);
  }
  return names;
}

using Names = std::vector<std::string>;

constexpr const char* kHead =
    "glider_ir 1\nmission m platform slocum\n"
    "sensor heading: angle vehicle m_heading id 7 encoding linear to_si 1 lowest 0 highest 7 "
    "stale_after 20\n"
    "sensor depth: length vehicle m_depth id 1 encoding linear to_si 1 lowest -1 highest 100 "
    "stale_after 20\n"
    "sensor altitude: length vehicle m_altitude id 3 encoding linear to_si 1 lowest 0 highest 100 "
    "stale_after 20\n"
    "sensor temp: temperature vehicle sci_water_temp id 2 encoding linear to_si 1 lowest -2 "
    "highest "
    "40 stale_after 20\n"
    "behaviour profile glide symbol gliderProfileGlide () reads (altitude)\n"
    "behaviour route drift symbol gliderRouteDrift () reads ()\n";

TEST(PrepareForFlight, KeepsTheSensorsThatSomethingElseReads) {
  Mission m = missionOf(std::string(kHead) + "require always (lt (sensor heading) 3:angle)\n" +
                        stateText("a", "case (gt (sensor temp) 5:temperature) exit"));
  ASSERT_EQ(m.requirements.size(), 1U);
  prepareForFlight(m);
  EXPECT_TRUE(m.requirements.empty());
  EXPECT_EQ(sensorsOf(m), (Names{"altitude", "temp"}));
  EXPECT_EQ(m.behaviours[0].reads.at(0).index, 0U) << "the profile reads the altitude";
  for (const Expr& expr : m.exprs) {
    if (expr.op == Op::Sensor) {
      EXPECT_EQ(m[expr.sensor].name, "temp");
    }
  }
}

TEST(PrepareForFlight, TablesOfGuardsFollowTheirSensors) {
  std::string cases;
  for (int i = 0; i < 40; ++i) {
    cases += "case (gt (sensor temp) " + std::to_string(i) + ":temperature) stay ";
  }
  Mission m = missionOf(std::string(kHead) + "require always (lt (sensor heading) 3:angle)\n" +
                        stateText("a", cases));
  opt::tabulateGuards(m);
  ASSERT_FALSE(m.states[0].table.columns.empty());
  prepareForFlight(m);
  for (const GuardColumn& column : m.states[0].table.columns) {
    ASSERT_TRUE(column.sensor.valid());
    EXPECT_EQ(m[column.sensor].name, "temp");
  }
}

TEST(PrepareForFlight, KeepsTheVariationOfTheCompass) {
  Mission m = missionOf(
      "glider_ir 1\nmission m platform slocum\n"
      "sensor altitude: length vehicle m_altitude id 3 encoding linear to_si 1 lowest 0 highest "
      "100 "
      "stale_after 20\n"
      "sensor variation: angle vehicle m_gps_mag_var id 4 encoding linear to_si 1 lowest -4 "
      "highest "
      "4 stale_after 20\n"
      "compass variation variation\n"
      "behaviour profile glide symbol gliderProfileGlide () reads ()\n"
      "behaviour route drift symbol gliderRouteDrift () reads ()\n"
      "require always (lt (sensor altitude) 90:length)\n" +
      stateText("a", "case true exit"));
  prepareForFlight(m);
  EXPECT_EQ(sensorsOf(m), Names{"variation"});
  ASSERT_TRUE(m.compass.has_value());
  EXPECT_EQ(m.compass->variation.index, 0U);
  EXPECT_TRUE(validate(m).empty());
}

TEST(PrepareForFlight, WithoutRequirementsNothingGoes) {
  Mission m = missionOf(std::string(kHead) + stateText("a", "case true exit"));
  prepareForFlight(m);
  EXPECT_EQ(m.sensors.size(), 4U);
}

}  // namespace
}  // namespace glider::ir
