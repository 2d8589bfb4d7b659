// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/scopes.h"
#include "ir/eval/interpreter.h"
#include "ir/verify/intervals.h"
#include "tests/random_missions/random_mission.h"
#include "tests/unit/ir/missions.h"

#include <limits>

namespace glider::ir {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();

struct Row {
  const char* text;
  double lowest, highest;
};

class Intervals : public testing::TestWithParam<Row> {};

/// depth lies in -1 .. 100 m, temp in -2 .. 40 degC.
TEST_P(Intervals, OfOneExpression) {
  const Mission m = missionOf(
      kHeader + "variable x: length mission lowest 3 highest 24 initial x 3:length " +
      "state a route drift () profile glide () entry do log \"r\" (" + GetParam().text + ") end");
  const Interval interval = intervalsOf(m).at(m.blocks[0].statements[0].values[0].index);
  EXPECT_FALSE(interval.empty);
  EXPECT_EQ(interval.lowest, GetParam().lowest);
  EXPECT_EQ(interval.highest, GetParam().highest);
}

const Row kRows[] = {
    {"(sensor depth)", -1, 100},
    {"(var x)", 3, 24},
    {"missiontime", 0, kMost},
    {"(add (sensor depth) (var x))", 2, 124},
    {"(sub (sensor depth) (var x))", -25, 97},
    {"(mul (sensor depth) (var x))", -24, 2400},
    {"(div (sensor depth) (var x))", -1.0 / 3, 100.0 / 3},
    {"(div (var x) (sensor depth))", -kMost, kMost},
    {"(neg (sensor depth))", -100, 1},
    {"(abs (sensor depth))", 0, 100},
    {"(sqrt (mul (sensor depth) 1:length))", 0, 10},
    {"(min (sensor depth) (var x))", -1, 24},
    {"(max (sensor depth) (var x))", 3, 100},
    {"(clamp (sensor depth) 3:length 24:length)", 3, 24},
    {"(clamp (sensor depth) (var x) 50:length)", 3, 50},
    {"(clamp (sensor depth) 24:length 3:length)", 3, 24},
    {"(clamp (var x) -1000:length 1000:length)", 3, 24},
    {"(select (known (sensor depth)) (sensor depth) 500:length)", -1, 500},
    {"(mul 1e300 (mul 1e300 (sensor depth)))", -kMost, kMost},
    {"(sin (div (mul 1:angle missiontime) 1:time))", -1, 1},
};

INSTANTIATE_TEST_SUITE_P(Rows, Intervals, testing::ValuesIn(kRows));

TEST(IntervalsTest, WhatAlwaysOverflowsIsNeverKnown) {
  const Mission m =
      missionOf(kHeader + "state a route drift () profile glide () entry do log \"r\" (" +
                "(mul 1e300 1e300)) end");
  EXPECT_TRUE(intervalsOf(m).back().empty);
}

/// Whatever the interpreter works out lies in its interval.
TEST(IntervalsTest, HoldWhatRandomMissionsWorkOut) {
  size_t looked_at = 0;
  for (uint64_t seed = 0; seed < 30; ++seed) {
    const Mission m = random_missions::randomMission(seed);
    const std::vector<Interval> intervals = intervalsOf(m);
    const std::vector<Reads> reads = readsOf(m);
    Interpreter interpreter(m, static_cast<uint32_t>(m.states.size()));
    const auto stream = random_missions::randomStream(m, seed, 40);
    for (size_t i = 0; i < stream.size(); ++i) {
      const TickResult now = i == 0 ? interpreter.start(stream[i].frame)
                                    : interpreter.tick(stream[i].mission_time, stream[i].frame);
      for (uint32_t e = 0; e < m.exprs.size(); ++e) {
        const bool seen = !reads[e].state.valid() || reads[e].state == now.state;
        if (m.exprs[e].type.kind == TypeKind::Bool || !seen) {
          continue;
        }
        const double value = interpreter.number({e});
        const Interval& interval = intervals[e];
        if (value == value) {
          ++looked_at;
          EXPECT_FALSE(interval.empty);
          EXPECT_GE(value, interval.lowest);
          EXPECT_LE(value, interval.highest);
        }
      }
      ASSERT_FALSE(HasFailure()) << seed;
    }
  }
  EXPECT_GT(looked_at, 300u);
}

}  // namespace
}  // namespace glider::ir
