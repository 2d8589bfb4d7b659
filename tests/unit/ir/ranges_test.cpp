// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/scopes.h"
#include "ir/eval/interpreter.h"
#include "ir/verify/intervals.h"
#include "tests/random_missions/random_mission.h"
#include "tests/unit/ir/missions.h"

#include <limits>
#include <numbers>

namespace glider::ir {
namespace {

constexpr double kMostNumber = std::numeric_limits<double>::max();
constexpr double kPi = std::numbers::pi;

struct Row {
  const char* text;
  double lowest, highest;
};

class Intervals : public testing::TestWithParam<Row> {};

/// depth lies in -1 .. 100 m, temp in -2 .. 40 degC.
TEST_P(Intervals, OfOneExpression) {
  const Mission m = missionOf(
      kHeader +
      "sensor lat: latitude vehicle m_lat id 12 encoding degrees_minutes to_si 1 lowest -3975 "
      "highest 3930 stale_after 20\n"
      "function f symbol f (): number lowest -3 highest 7\nuse f\n"
      "table number (4, -9, 2)\n"
      "variable x: length mission lowest 3 highest 24 initial x 3:length "
      "temporal lowest always (sensor depth) over 10\n"
      "temporal highest always (sensor depth) over 10\n"
      "temporal spread always (sensor depth) over 10\n"
      "temporal mean always (sensor depth) over 10\n"
      "temporal spread always (mul (mul 1e300 1e300) (sensor depth)) over 10\n" +
      "state a route drift () profile glide () entry do log \"r\" (" + GetParam().text + ") end");
  const Interval interval = intervalsOf(m).at(m.blocks[0].statements[0].values[0].index);
  EXPECT_FALSE(interval.empty);
  EXPECT_EQ(interval.lowest, GetParam().lowest);
  EXPECT_EQ(interval.highest, GetParam().highest);
}

const Row kRows[] = {
    {"(sensor depth)", -1, 100},
    {"(var x)", 3, 24},
    {"missiontime", 0, kMostNumber},
    {"(add (sensor depth) (var x))", 2, 124},
    {"(sub (sensor depth) (var x))", -25, 97},
    {"(mul (sensor depth) (var x))", -24, 2400},
    {"(div (sensor depth) (var x))", -1.0 / 3, 100.0 / 3},
    {"(div (var x) (sensor depth))", -kMostNumber, kMostNumber},
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
    {"(mul 1e300 (mul 1e300 (sensor depth)))", -kMostNumber, kMostNumber},
    {"(sin (div (mul 1:angle missiontime) 1:time))", -1, 1},
    {"(cos (div (mul 1:angle missiontime) 1:time))", -1, 1},
    {"(tan (div (mul 1:angle missiontime) 1:time))", -kMostNumber, kMostNumber},
    {"(atan2 (sensor depth) (var x))", -kPi, kPi},
    {"(distance (sensor lat) 2:longitude 4:latitude 3:longitude)", 0, 2.0016e7},
    {"(bearing (sensor lat) 2:longitude 4:latitude 3:longitude)", 0, 2 * kPi},
    {"(sensor lat)", -40, 39.5},
    {"statetime", 0, kMostNumber},
    {"(age depth)", 0, kMostNumber},
    {"(call 0)", -3, 7},
    {"(element 0 (div (var x) 1:length))", -9, 4},
    {"(temporal 0)", -1, 100},
    {"(temporal 1)", -1, 100},
    {"(temporal 2)", 0, 101},
    {"(temporal 3)", -kMostNumber, kMostNumber},
    // What divides may be 0, or nearly.
    {"(div (var x) (clamp (sensor depth) 0:length 5:length))", -kMostNumber, kMostNumber},
    {"(div (var x) (clamp (sensor depth) -1:length 0:length))", -kMostNumber, kMostNumber},
    {"(div (var x) (clamp (sensor depth) 1:length 5:length))", 0.6, 24},
    {"(div (var x) (clamp (sensor depth) -1:length -0.5:length))", -48, -3},
    {"(abs (var x))", 3, 24},
    {"(abs (clamp (sensor depth) -1:length -0.5:length))", 0.5, 1},
    {"(abs (clamp (sensor depth) -1:length 0.5:length))", 0, 1},
    {"(sqrt (mul (clamp (sensor depth) -1:length 0:length) 1:length))", 0, 0},
    {"(sqrt (mul (clamp (sensor depth) 4:length 9:length) 1:length))", 2, 3},
    {"(mul -1 (sensor depth))", -100, 1},
    {"(mul (sensor depth) (sensor depth))", -100, 10000},
    {"(clamp (sensor depth) -5:length (var x))", -1, 24},
    {"(clamp (sensor depth) 90:length (var x))", 3, 90},
    {"(clamp (var x) (sensor depth) (sensor depth))", -1, 100},
    {"(clamp (var x) 24:length 30:length)", 24, 24},
    {"(clamp (var x) 1:length 3:length)", 3, 3},
    {"(clamp (var x) 3:length 24:length)", 3, 24},
    {"(select (known (sensor depth)) 5:length (sensor depth))", -1, 100},
    {"(select (known (sensor depth)) (mul (mul 1e300 1e300) 1:length) 5:length)", 5, 5},
    {"(select (known (sensor depth)) 5:length (mul (mul 1e300 1e300) 1:length))", 5, 5},
    // What settles is 0, and the greatest number is one.
    {"(mul 1e-300 (mul 1e-300 (sensor depth)))", 0, 0},
    {"(div (mul 1e-300 (sensor depth)) 1e300)", 0, 0},
    {"(add 1.7976931348623157e308 0)", kMostNumber, kMostNumber},
    {"(sub -1.7976931348623157e308 0)", -kMostNumber, -kMostNumber},
};

INSTANTIATE_TEST_SUITE_P(Rows, Intervals, testing::ValuesIn(kRows));

TEST(IntervalsTest, WhatAlwaysOverflowsIsNeverKnown) {
  const Mission m =
      missionOf(kHeader + "state a route drift () profile glide () entry do log \"r\" (" +
                "(mul 1e300 1e300)) end");
  EXPECT_TRUE(intervalsOf(m).back().empty);
  for (const char* text : {"(mul -1e300 1e300)", "(add 1.7e308 1.7e308)", "(sub -1.7e308 1.7e308)",
                           "(add 1 (mul 1e300 1e300))", "(sub (mul 1e300 1e300) 1)",
                           "(neg (mul 1e300 1e300))", "(sqrt -1)", "(min 1 (mul 1e300 1e300))"}) {
    const Mission other = missionOf(
        kHeader + "state a route drift () profile glide () entry do log \"r\" (" + text + ") end");
    EXPECT_TRUE(intervalsOf(other).back().empty) << text;
  }
}

/// Every value that the interpreter computes lies in its interval.
TEST(IntervalsTest, HoldWhatRandomMissionsCompute) {
  size_t looked_at = 0;
  for (uint64_t seed = 0; seed < 30; ++seed) {
    const Mission m = random_missions::randomMission(seed);
    const std::vector<Interval> intervals = intervalsOf(m);
    const std::vector<Reads> reads = readsOf(m);
    Interpreter interpreter(m, static_cast<uint32_t>(m.states.size()),
                            random_missions::randomExternals());
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
