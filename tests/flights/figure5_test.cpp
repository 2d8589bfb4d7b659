// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The paper's Figure 5: three layered yos, the SBC tracking the thermocline in between.

#include "tests/flights/flight.h"

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

TEST(Figure5, TheOrderedRangeHoldsTheIsotherm) {
  const Flight flight = flyFigure5();
  const auto active = flight.column("hook_active");
  const auto top = flight.column("order_top");
  const auto bottom = flight.column("order_bottom");
  const auto isotherm = flight.column("isotherm_depth");
  const auto depth = flight.column("true_depth");
  // Detection is where the ordered range first becomes narrow; one yo later the figures are taken.
  size_t detected = 0;
  while (detected < active.size() && !(bottom[detected] - top[detected] <= 12)) {
    ++detected;
  }
  ASSERT_LT(detected, active.size());
  const size_t last = lastOf(active, 1.0);
  const auto turns = deepTurns(depth, detected, last);
  ASSERT_GE(turns.size(), 3U);
  size_t ticks = 0;
  size_t inside = 0;
  for (size_t i = turns[0]; i <= last; ++i) {
    ++ticks;
    inside += top[i] <= isotherm[i] && isotherm[i] <= bottom[i] ? 1U : 0U;
    EXPECT_LE(bottom[i] - top[i], 12) << "at tick " << i;
  }
  EXPECT_GE(static_cast<double>(inside), 0.9 * static_cast<double>(ticks))
      << inside << " of " << ticks;
}

TEST(Figure5, TheLayeredYoThenCompletesItsThree) {
  const Flight flight = flyFigure5();
  const auto depth = flight.column("true_depth");
  const auto active = flight.column("hook_active");
  size_t layered = 0;
  for (const size_t turn : deepTurns(depth, 0, depth.size())) {
    layered += active[turn] == 0 ? 1U : 0U;
  }
  EXPECT_EQ(layered, 3U);
}

TEST(Figure5, TwiceIsTheSameToTheByte) {
  EXPECT_EQ(flyFigure5().csv, flyFigure5().csv);
}

TEST(Figure5, WithoutHookbehTheSbcChangesNothing) {
  const std::string scenario = " --scenario " + project("scenarios/layered.toml");
  const Flight absent = fly("--no-sbc" + scenario);
  const Flight present = fly(project("missions/figure5.mission") + scenario);
  ASSERT_EQ(absent.outcome.status, 0) << absent.outcome.err;
  ASSERT_EQ(present.outcome.status, 0) << present.outcome.err;
  EXPECT_GT(absent.rows.size(), 100U);
  EXPECT_EQ(absent.csv, present.csv);
}

}  // namespace
}  // namespace glider::tests
