// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The paper's Figure 5: three layered yos, the SBC tracking the thermocline in between. How well it
// does is the matter of thermocline_test.cpp.

#include "tests/flights/flight.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glider::tests {
namespace {

Flight flyFigure5(const std::string& more = "") {
  return fly(project("missions/figure5.mission") + " --scenario " +
             project("scenarios/figure5.toml") + more);
}

/// The turns of the true depth (a change of direction of at least 2 m).
std::vector<size_t> deepTurns(const std::vector<double>& depth, size_t begin, size_t end) {
  std::vector<size_t> turns;
  size_t extreme = begin;
  for (size_t i = begin; i < end; ++i) {
    if (depth[i] > depth[extreme]) {
      extreme = i;
    } else if (depth[extreme] - depth[i] > 2 && depth[extreme] - depth[begin] > 2) {
      turns.push_back(extreme);
      // Wait for the next dive: skip the climb.
      while (i + 1 < end && depth[i + 1] <= depth[i]) {
        ++i;
      }
      begin = extreme = i;
    }
  }
  return turns;
}

/// The last place of `value`; 0 if there is none.
size_t lastOf(const std::vector<double>& values, double value) {
  size_t last = 0;
  for (size_t i = 0; i < values.size(); ++i) {
    last = values[i] == value ? i : last;
  }
  return last;
}

TEST(Figure5, HookbehHoldsControlFrom260To1460Seconds) {
  const Flight flight = flyFigure5();
  ASSERT_EQ(flight.outcome.status, 0) << flight.outcome.err;
  const auto time = flight.column("time");
  const auto active = flight.column("hook_active");
  const auto first = static_cast<size_t>(std::ranges::find(active, 1.0) - active.begin());
  ASSERT_LT(first, active.size());
  const size_t last = lastOf(active, 1.0);
  EXPECT_GE(time[first], 260);
  EXPECT_LE(time[first], 268);
  EXPECT_GE(time[last], 1452);
  EXPECT_LE(time[last], 1468);
}

TEST(Figure5, TheLayeredYoThenCompletesItsThree) {
  const Flight flight = flyFigure5();
  const auto depth = flight.column("true_depth");
  const auto active = flight.column("hook_active");
  // Those that reach the 30 m of figure5.mi; when control is released it turns at some 12 m to go
  // on with the climb it was in.
  size_t layered = 0;
  for (const size_t turn : deepTurns(depth, 0, depth.size())) {
    layered += active[turn] == 0 && depth[turn] >= 30 ? 1U : 0U;
  }
  EXPECT_EQ(layered, 3U);
}

TEST(Figure5, TwiceIsTheSameToTheByte) {
  EXPECT_EQ(flyFigure5().csv, flyFigure5().csv);
}

TEST(Figure5, WithoutHookbehTheSbcChangesNothing) {
  // It draws no power here: the voltage would tell.
  const TemporaryFolder folder;
  (void)folder.write("layered.mi", slurp(project("scenarios/layered.mi")));
  const std::string text = slurp(project("scenarios/layered.toml"));
  const std::string scenario =
      " --scenario " +
      folder.write("layered.toml", text + "\n[vehicle.battery]\nsbc_W = 0\n").string();
  const Flight absent = fly("--no-sbc" + scenario);
  const Flight present = fly(project("missions/figure5.mission") + scenario);
  ASSERT_EQ(absent.outcome.status, 0) << absent.outcome.err;
  ASSERT_EQ(present.outcome.status, 1) << present.outcome.err;
  EXPECT_NE(present.outcome.err.find("GL9372"), std::string::npos) << present.outcome.err;
  EXPECT_GT(absent.rows.size(), 100U);
  EXPECT_EQ(absent.csv, present.csv);
}

}  // namespace
}  // namespace glider::tests
