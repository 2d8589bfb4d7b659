// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The windows of the interpreter, compared with values computed by hand.

#include "ir/eval/window.h"

#include <gtest/gtest.h>

#include <limits>

namespace glider::ir {
namespace {

constexpr double kGapInWindow = std::numeric_limits<double>::quiet_NaN();
constexpr double kGreatestBin = 4503599627370496;  // 2^52

struct Tick {
  double time, along, value;
  bool fresh = true;
};

bool isUnknown(double value) {
  return value != value;
}

/// Of 10 s in bins of 4 s, or of 16 m in bins of 1 m, started at 0.
double after(TemporalKind kind, bool stretch, const std::vector<Tick>& ticks) {
  PlainWindow window({kind, stretch, stretch ? 16.0 : 10.0, stretch ? 1.0 : 4.0, 99});
  window.start(0);
  for (const Tick& t : ticks) {
    window.advance(t.time, t.along, t.value, t.fresh);
  }
  return window.value();
}
double overTime(TemporalKind kind, const std::vector<Tick>& ticks) {
  return after(kind, false, ticks);
}
double overDepth(TemporalKind kind, const std::vector<Tick>& ticks) {
  return after(kind, true, ticks);
}

constexpr TemporalKind kMean = TemporalKind::Mean, kLowest = TemporalKind::Lowest,
                       kHighest = TemporalKind::Highest, kSpread = TemporalKind::Spread,
                       kSlope = TemporalKind::Slope;

TEST(PlainWindow, WorksOutWhatItHolds) {
  const std::vector<Tick> ticks = {{0, 0, 7}, {4, 4, 3}, {8, 8, 11}, {10, 10, 9}};
  // The last two are in one bin, whose newest reading counts.
  EXPECT_EQ(overTime(kMean, ticks), (7.0 + 3 + 9) / 3);
  EXPECT_EQ(overTime(kLowest, ticks), 3);
  EXPECT_EQ(overTime(kHighest, ticks), 9);
  EXPECT_EQ(overTime(kSpread, ticks), 6);
  const std::vector<Tick> line = {{0, 0, 5}, {4, 4, 13}, {8, 8, 21}, {10, 10, 25}};
  EXPECT_EQ(overTime(kSlope, line), 2);
  EXPECT_EQ(overTime(kSlope, {{0, 0, 5}, {4, 4, 5}, {10, 10, 14}}), 144.0 / 152)
      << "by least squares";
}

TEST(PlainWindow, IsKnownOnceItsTimeIsOver) {
  EXPECT_TRUE(isUnknown(overTime(kMean, {{0, 0, 7}, {9.9, 9.9, 7}})));
  EXPECT_EQ(overTime(kMean, {{0, 0, 7}, {10, 10, 7}}), 7);
  EXPECT_EQ(overTime(kHighest, {{0, 0, 9}, {10, 10, 7}}), 9) << "just as old";
  EXPECT_EQ(overTime(kHighest, {{0, 0, 9}, {10.1, 10.1, 7}}), 7) << "too old";
  EXPECT_TRUE(isUnknown(overTime(kMean, {{0, 0, 7}, {20, 20, 7, false}}))) << "empty";
  EXPECT_TRUE(isUnknown(overTime(kSlope, {{10, 10, 7}}))) << "one reading has no slope";
}

TEST(PlainWindow, TakesOnlyFreshKnownReadings) {
  EXPECT_EQ(overTime(kHighest, {{0, 0, 7}, {8, 8, 9, false}, {10, 10, 5}}), 7);
  EXPECT_EQ(overTime(kHighest, {{0, 0, 7}, {8, 8, kGapInWindow}, {10, 10, 5}}), 7);
  EXPECT_TRUE(isUnknown(overDepth(kMean, {{0, 0, 7}, {4, 16, 7}, {8, kGapInWindow, 7}})));
  EXPECT_EQ(overDepth(kMean, {{0, 0, 7}, {4, 16, 7}, {8, kGapInWindow, 99}, {12, 16, 7}}), 7);
}

TEST(PlainWindow, OfAStretchIsKnownOnceItHasBeenCrossed) {
  EXPECT_TRUE(isUnknown(overDepth(kMean, {{0, 10, 7}, {4, 25.9, 7}})));
  EXPECT_EQ(overDepth(kMean, {{0, 10, 7}, {4, 26, 7}}), 7);
  EXPECT_EQ(overDepth(kMean, {{0, 26, 7}, {4, 10, 7}}), 7) << "upwards";
  EXPECT_EQ(overDepth(kMean, {{0, 10, 7}, {4, 26, 7}, {8, 20, 7}}), 7) << "and stays so";
  EXPECT_TRUE(isUnknown(overDepth(kMean, {{0, 10, 7}, {4, 26, 7, false}}))) << "by fresh readings";
}

TEST(PlainWindow, OfAStretchReachesToBothSides) {
  const std::vector<Tick> way = {{0, 10, 1}, {4, 26, 5}, {8, 30, 9}};
  EXPECT_EQ(overDepth(kLowest, way), 5) << "10 m is 20 m off";
  std::vector<Tick> back = way;
  back.push_back({12, 14, 7});
  EXPECT_EQ(overDepth(kLowest, back), 7) << "26 m was passed again, unread";
  EXPECT_EQ(overDepth(kHighest, back), 9) << "30 m is 16 m off";
}

TEST(PlainWindow, OfAStretchForgets) {
  const auto kept = [](double later) {
    return overDepth(kHighest, {{0, 10, 9}, {4, 26, 5}, {later, 26, 5}});
  };
  EXPECT_EQ(kept(1800), 9);
  EXPECT_EQ(kept(1800.1), 5);
}

TEST(PlainWindow, WhatIsCrossedAgainIsNew) {
  // From 26 m to 10 m nothing was read in between: what was there is out of date.
  EXPECT_EQ(overDepth(kHighest, {{0, 10, 1}, {4, 18, 9}, {8, 26, 1}, {12, 10, 1}}), 1);
  EXPECT_EQ(overDepth(kHighest, {{0, 10, 1}, {4, 18, 9}, {8, 26, 1}, {12, 18, 1}}), 1);
  EXPECT_EQ(overDepth(kHighest, {{0, 10, 1}, {4, 18, 9}, {8, 26, 1}, {12, 19, 1}}), 9);
  EXPECT_EQ(overDepth(kHighest, {{0, 18, 9}, {4, 10, 1}, {8, 26, 1}}), 1) << "downwards";
}

TEST(PlainWindow, TakesNoBinThatHasNoNumber) {
  const double far = kGreatestBin;
  EXPECT_TRUE(isUnknown(overDepth(kMean, {{0, far, 7}}))) << "not taken, and nothing crossed";
  EXPECT_TRUE(isUnknown(overDepth(kHighest, {{0, 0, 1}, {4, far, 7}})));
  EXPECT_TRUE(isUnknown(overDepth(kHighest, {{0, 0, 1}, {4, -far, 7}})));
  EXPECT_EQ(overDepth(kHighest, {{0, 0, 1}, {4, far - 1, 7}}), 7);
  EXPECT_EQ(overDepth(kHighest, {{0, 0, 1}, {4, 1 - far, 7}}), 7);
}

TEST(PlainWindow, Restarts) {
  PlainWindow window({kHighest, false, 10, 4, 99});
  window.start(0);
  window.advance(0, 0, 9, true);
  window.advance(10, 10, 5, true);
  EXPECT_EQ(window.value(), 9);
  window.start(12);
  EXPECT_TRUE(isUnknown(window.value()));
  window.advance(12, 12, 4, true);
  window.advance(21, 21, 4, true);
  EXPECT_TRUE(isUnknown(window.value())) << "9 s since it began";
  window.advance(22, 22, 4, true);
  EXPECT_EQ(window.value(), 4) << "what was before is forgotten";
}

}  // namespace
}  // namespace glider::ir
