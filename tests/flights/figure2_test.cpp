// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The paper's Figure 2, flown all four ways.

#include "tests/flights/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glider::tests {
namespace {

constexpr double kCycle = 4;

Flight flyFigure2(const std::string& way) {
  return fly(project("missions/figure2.mission") + " --scenario " +
             project("scenarios/default.toml") + way);
}

void expectFigure2(const std::vector<Event>& transitions) {
  const std::pair<const char*, double> expected[] = {{"s1 → s2 (call)", 500},
                                                     {"s2 → s1 (return)", 1500},
                                                     {"s1 → s3 (goto)", 2000},
                                                     {"s3 → end (exit)", 2500}};
  ASSERT_EQ(transitions.size(), std::size(expected));
  for (size_t i = 0; i < transitions.size(); ++i) {
    EXPECT_EQ(transitions[i].what, expected[i].first);
    EXPECT_GE(transitions[i].mission_time_s, expected[i].second);
    EXPECT_LE(transitions[i].mission_time_s, expected[i].second + kCycle);
  }
}

TEST(Figure2, FollowsThePapersTimes) {
  const Flight flight = flyFigure2("");
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  expectFigure2(flight.transitions());
}

TEST(Figure2, YosBetweenTheCommandedDepths) {
  const Flight flight = flyFigure2("");
  const auto state = flight.column("state");
  const auto mission_time = flight.column("missiontime");
  const auto depth = flight.column("true_depth");
  ASSERT_FALSE(depth.empty());
  // 5 to 10 m in s1 once it is down there. A turn is seen at the next cycle, commanded at the one
  // after, and the pump then needs twelve seconds more: about 4 m at 0.17 m/s.
  double shallowest = 1e9;
  double deepest = 0;
  int turns = 0;
  for (size_t i = 1; i < depth.size(); ++i) {
    if (state[i] == 0 && mission_time[i] > 150 && mission_time[i] < 500) {
      shallowest = std::min(shallowest, depth[i]);
      deepest = std::max(deepest, depth[i]);
      turns += (depth[i] >= 7.5) != (depth[i - 1] >= 7.5) ? 1 : 0;
    }
  }
  EXPECT_GT(shallowest, 1);
  EXPECT_LE(shallowest, 5.5);
  EXPECT_GE(deepest, 9.5);
  EXPECT_LT(deepest, 14);
  EXPECT_GE(turns, 3);
}

class Figure2Ways : public testing::TestWithParam<const char*> {};

TEST_P(Figure2Ways, GiveTheSameTransitionsAtTheSameTimes) {
  const Flight in_process = flyFigure2("");
  const Flight other = flyFigure2(std::string(" --board ") + GetParam());
  ASSERT_EQ(other.outcome.status, 0) << other.outcome.err;
  const auto expected = in_process.transitions();
  const auto seen = other.transitions();
  ASSERT_EQ(seen.size(), expected.size());
  for (size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i].what, expected[i].what);
    EXPECT_EQ(seen[i].time_s, expected[i].time_s);
    EXPECT_EQ(seen[i].mission_time_s, expected[i].mission_time_s);
    EXPECT_EQ(seen[i].why, expected[i].why);
  }
  EXPECT_EQ(other.csv, in_process.csv);
  ASSERT_EQ(other.events.size(), in_process.events.size());
  for (size_t i = 0; i < other.events.size(); ++i) {
    EXPECT_EQ(other.events[i].time_s, in_process.events[i].time_s) << in_process.events[i].what;
    EXPECT_EQ(other.events[i].what, in_process.events[i].what);
    EXPECT_EQ(other.events[i].why, in_process.events[i].why);
  }
}

INSTANTIATE_TEST_SUITE_P(, Figure2Ways,
                         testing::Values("host", "ts7800", "ts5500", "pizero2", "cm4"));

TEST(Figure2, TheCommandedRangeIsTheCurrentStates) {
  const Flight flight = flyFigure2("");
  const auto state = flight.column("state");
  const auto top = flight.column("commanded_top");
  const auto bottom = flight.column("commanded_bottom");
  // s1 commands 5 to 10 m, s3 5 to 20 m. After a transition the new command appears within three
  // rows.
  size_t rows = 0, with_top = 0, with_bottom = 0;
  double was_top = 0, was_bottom = 0;  // the command in force stays until one in its direction
  for (size_t i = 3; i < state.size(); ++i) {
    if (state[i] != state[i - 1]) {
      was_top = top[i - 1], was_bottom = bottom[i - 1];
    }
    const bool settled =
        state[i] == state[i - 1] && state[i] == state[i - 2] && state[i] == state[i - 3];
    if (settled && (state[i] == 0 || state[i] == 2)) {
      const double deepest = state[i] == 0 ? 10 : 20;
      EXPECT_TRUE(std::isnan(bottom[i]) || bottom[i] == deepest || bottom[i] == was_bottom)
          << bottom[i] << " in row " << i;
      EXPECT_TRUE(std::isnan(top[i]) || top[i] == 5 || top[i] == was_top)
          << top[i] << " in row " << i;
      ++rows;
      with_top += std::isnan(top[i]) ? 0U : 1U;
      with_bottom += std::isnan(bottom[i]) ? 0U : 1U;
    }
  }
  // 1500 s in s1 and s3 at a row in 4 s; a leg after a transition does not know the other end yet.
  EXPECT_GT(rows, 330U);
  EXPECT_GT(with_bottom, rows * 9 / 10);
  EXPECT_GT(with_top, rows / 2);
}

/// Flies Figure 2's program for the host, which takes `secs` of real time to end.
Flight flyLingering(const TemporaryFolder& folder, const std::string& secs) {
  const std::string program = (folder.path() / "figure2").string();
  EXPECT_EQ(
      runShell("$GLIDERCC build " + project("missions/figure2.mission") + " -o " + program).status,
      0);
  const auto sbc = folder.write("sbc", "#!/bin/sh\n" + program + " \"$@\"\nsleep " + secs + "\n");
  EXPECT_EQ(runShell("chmod +x " + sbc.string()).status, 0);
  return fly("--sbc " + sbc.string() + " --scenario " + project("scenarios/default.toml"));
}

TEST(Figure2, DoesNotDependOnHowLongTheProgramTakesToEnd) {
  const TemporaryFolder folder;
  const Flight quick = flyLingering(folder, "0");
  const Flight slow = flyLingering(folder, "0.4");
  ASSERT_EQ(quick.outcome.status, 0) << quick.outcome.err;
  EXPECT_EQ(slow.csv, quick.csv);
  ASSERT_EQ(slow.events.size(), quick.events.size());
  for (size_t i = 0; i < slow.events.size(); ++i) {
    EXPECT_EQ(slow.events[i].time_s, quick.events[i].time_s) << quick.events[i].what;
    EXPECT_EQ(slow.events[i].what, quick.events[i].what);
  }
}

TEST(Figure2, AnSbcThatHasDoneItsWorkIsNotCalledLost) {
  const auto calledLost = [](const Flight& flight) {
    return std::ranges::any_of(flight.events, [](const Event& e) {
      return e.what.find("no answer from the SBC") != std::string::npos;
    });
  };
  const Flight flight = flyFigure2("");
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  EXPECT_FALSE(calledLost(flight));
  EXPECT_TRUE(calledLost(flyFigure2(" --kill-sbc-at 700")))
      << "those are the words for one that is";
}

}  // namespace
}  // namespace glider::tests
