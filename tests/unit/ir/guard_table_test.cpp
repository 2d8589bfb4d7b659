// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a table of guards says is what the guards say.

#include "ir/core/validate.h"
#include "ir/eval/interpreter.h"
#include "ir/opt/passes.h"
#include "ir/text/print.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random_mission.h"
#include "tests/unit/ir/missions.h"

#include <algorithm>
#include <cmath>

namespace glider::ir {
namespace {

double valueOf(const Interpreter& interpreter, const Mission& m, const GuardColumn& column) {
  for (uint32_t i = 0; i < m.exprs.size(); ++i) {
    if (m.exprs[i].op == column.source && m.exprs[i].sensor == column.sensor) {
      return interpreter.number({i});
    }
  }
  ADD_FAILURE() << "a column that no expression reads";
  return 0;
}

uint32_t intervalOf(const GuardColumn& column, double value) {
  if (value != value) {
    return column.unknown();
  }
  return static_cast<uint32_t>(std::ranges::count_if(column.cuts, [&](const Cut& cut) {
    return cut.inclusive ? value >= cut.at : value > cut.at;
  }));
}

bool holds(const GuardRow& row, const std::vector<uint32_t>& intervals) {
  bool all = true;
  for (size_t i = 0; i < intervals.size(); ++i) {
    all = all && row.within[i].first <= intervals[i] && intervals[i] <= row.within[i].last;
  }
  return all;
}

struct Looked {
  size_t tables = 0;
  size_t exact = 0;  ///< rows that held, without a guard to ask
};

/// Compares a table with its cases at this tick.
void compare(const Interpreter& interpreter, const Mission& m, const GuardTable& table,
             const std::vector<Case>& cases, Looked& looked) {
  std::vector<uint32_t> intervals;
  for (const GuardColumn& column : table.columns) {
    intervals.push_back(intervalOf(column, valueOf(interpreter, m, column)));
  }
  ++looked.tables;
  std::vector<bool> may(cases.size());
  for (const GuardRow& row : table.rows) {
    if (holds(row, intervals)) {
      may[row.number] = true;
      looked.exact += row.exact;
      if (row.exact) {
        EXPECT_EQ(interpreter.truthOf(cases[row.number].guard), Truth::True) << row.number;
      }
    }
  }
  for (size_t i = 0; i < cases.size(); ++i) {
    EXPECT_TRUE(may[i] || interpreter.truthOf(cases[i].guard) != Truth::True) << i;
  }
}

TEST(GuardTable, SaysWhatTheGuardsSay) {
  Looked looked;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Mission m = random_missions::randomMission(seed);
    opt::tabulateGuards(m);
    Interpreter interpreter(m, static_cast<uint32_t>(m.states.size()));
    const auto stream = random_missions::randomStream(m, seed, 60);
    for (size_t i = 0; i < stream.size(); ++i) {
      const TickResult now = i == 0 ? interpreter.start(stream[i].frame)
                                    : interpreter.tick(stream[i].mission_time, stream[i].frame);
      if (const State& state = m[now.state]; !state.table.empty()) {
        compare(interpreter, m, state.table, state.cases, looked);
      }
      ASSERT_FALSE(HasFailure()) << "tick " << i;
    }
  }
  EXPECT_GT(looked.tables, 300u);
  EXPECT_GT(looked.exact, 1000u);
}

/// Cases of one threshold each.
std::string longList(int count = 16) {
  std::string cases;
  for (int i = 0; i < count; ++i) {
    cases += "case (ge (sensor depth) " + std::to_string(i) + ":length) stay ";
  }
  return cases;
}

TEST(GuardTable, ShortListsHaveNone) {
  Mission m = missionOf(kHeader + stateText("a", longList(15)));
  opt::tabulateGuards(m);
  EXPECT_TRUE(m.states[0].table.empty());
}

/// A table numbers 4096 cases; more fly without one.
TEST(GuardTable, TooLongListsHaveNone) {
  Mission m = missionOf(kHeader + stateText("a", longList(5000)));
  opt::tabulateGuards(m);
  EXPECT_TRUE(m.states[0].table.empty());
  EXPECT_TRUE(validate(m).empty());
}

TEST(GuardTable, HasRoomFor4096Rows) {
  for (const int count : {4096, 4097}) {
    Mission m = missionOf(kHeader + stateText("a", longList(count)));
    opt::tabulateGuards(m);
    EXPECT_EQ(m.states[0].table.empty(), count > 4096) << count;
  }
}

/// "case (and (or …) (or …))", of so many comparisons each.
std::string eitherOf(int left, int right) {
  const auto any = [](int count, const std::string& sensor, const std::string& unit) {
    std::string text = "(gt (sensor " + sensor + ") 1:" + unit + ")";
    for (int i = 1; i < count; ++i) {
      text = "(or " + text + " (gt (sensor " + sensor + ") " + std::to_string(i + 1) + ":" + unit +
             "))";
    }
    return text;
  };
  return "case (and " + any(left, "depth", "length") + " " + any(right, "temp", "temperature") +
         ") stay";
}

TEST(GuardTable, EightAlternativesAreThresholdsYet) {
  const auto rows = [](const std::string& cases) {
    Mission m = missionOf(kHeader + stateText("a", longList() + cases));
    opt::tabulateGuards(m);
    return m.states[0].table.rows;
  };
  EXPECT_EQ(rows(eitherOf(8, 1)).size(), 16U + 8);
  EXPECT_TRUE(rows(eitherOf(8, 1)).back().exact);
  EXPECT_EQ(rows(eitherOf(9, 1)).size(), 16U + 1);
  EXPECT_FALSE(rows(eitherOf(9, 1)).back().exact);
  EXPECT_EQ(rows(eitherOf(2, 4)).size(), 16U + 8);
  EXPECT_TRUE(rows(eitherOf(2, 4)).back().exact);
  EXPECT_EQ(rows(eitherOf(3, 3)).size(), 16U + 1);
  EXPECT_FALSE(rows(eitherOf(3, 3)).back().exact);
}

TEST(GuardTable, AThresholdCutsOnceHoweverOftenItIsUsed) {
  Mission m =
      missionOf(kHeader + stateText("a", longList() + "case (and (lt (sensor depth) 3:length) "
                                                      "(known (sensor temp))) stay "
                                                      "case (not (or (gt 3:length (sensor depth)) "
                                                      "(known (sensor temp)))) stay"));
  opt::tabulateGuards(m);
  const GuardTable& table = m.states[0].table;
  ASSERT_EQ(table.columns.size(), 2u);
  EXPECT_EQ(table.columns[0].cuts.size(), 16u);
  EXPECT_TRUE(table.columns[1].cuts.empty());
  ASSERT_EQ(table.rows.size(), 18u);
  EXPECT_EQ(table.rows[16].within[0], (GuardRow::Range{0, 3}));
  EXPECT_EQ(table.rows[16].within[1], (GuardRow::Range{0, 0})) << "known";
  EXPECT_EQ(table.rows[17].within[0], (GuardRow::Range{4, 16})) << "not below 3 m, and known";
  EXPECT_EQ(table.rows[17].within[1], (GuardRow::Range{1, 1})) << "unknown";
}

TEST(GuardTable, ThereIsOneZero) {
  Mission m =
      missionOf(kHeader + stateText("a", "case (gt (sensor depth) -0:length) stay " + longList()));
  opt::tabulateGuards(m);
  for (const Cut& cut : m.states[0].table.columns.at(0).cuts) {
    EXPECT_FALSE(std::signbit(cut.at)) << cut.at;
  }
}

TEST(GuardTable, WhatIsMoreThanThresholdsIsAsked) {
  Mission m =
      missionOf(kHeader + stateText("a", longList() + "case (and (lt (sensor depth) 3:length) "
                                                      "(gt (age temp) 9:time)) stay"));
  opt::tabulateGuards(m);
  ASSERT_FALSE(m.states[0].table.empty());
  EXPECT_FALSE(m.states[0].table.rows.back().exact);
}

TEST(GuardTable, PrintsAndReadsBack) {
  Mission m = missionOf(kHeader + "always " + longList() +
                        stateText("a", longList() + "case (gt missiontime 5:time) exit"));
  opt::tabulateGuards(m);
  ASSERT_FALSE(m.always_table.empty());
  const Mission again = missionOf(print(m));
  EXPECT_EQ(print(again), print(m));
  EXPECT_EQ(again.states[0].table.columns.size(), 2u);
}

}  // namespace
}  // namespace glider::ir
