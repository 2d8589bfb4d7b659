// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is kept of the water that was read, and the thermocline in it.

#include "runtime/c/water_column.h"

#include <gtest/gtest.h>

#include <vector>

namespace glider::runtime::testing {
namespace {

struct At {
  double time, depth, temperature;
};

WaterColumn columnOf(const std::vector<At>& readings) {
  WaterColumn column;
  column.clear();
  for (const At& reading : readings) {
    column.record(reading.time, reading.depth, reading.temperature);
  }
  return column;
}

TEST(WaterColumn, HasNothingBeforeTwoReadings) {
  const WaterColumn none = columnOf({});
  EXPECT_EQ(none.steepest(10, 0).difference, 0);
  EXPECT_FALSE(none.crossing(0, 0).found);
  const WaterColumn one = columnOf({{0, 5, 20}});
  EXPECT_EQ(one.steepest(10, 0).difference, 0);
  EXPECT_FALSE(one.crossing(20, 0).found);
}

TEST(WaterColumn, TheSteepestStretchIsOfItsLengthAtMost) {
  const WaterColumn column = columnOf({{0, 5, 20}, {1, 6, 19}, {2, 8, 14}, {3, 9, 15}});
  const Stretch whole = column.steepest(4, 0);
  EXPECT_EQ(whole.difference, 6);
  EXPECT_EQ(whole.middle, 17);
  EXPECT_EQ(column.steepest(3, 0).difference, 6) << "from 5 to 8 m";
  const Stretch two = column.steepest(2, 0);
  EXPECT_EQ(two.difference, 5) << "from 6 to 8 m";
  EXPECT_EQ(two.middle, 16.5);
  EXPECT_EQ(column.steepest(1.5, 0).difference, 1);
  EXPECT_EQ(column.steepest(0.5, 0).difference, 0);
}

TEST(WaterColumn, OfTwoAsSteepTheShallowerCounts) {
  const Stretch found = columnOf({{0, 5, 20}, {1, 6, 18}, {2, 15, 10}, {3, 16, 8}}).steepest(1, 0);
  EXPECT_EQ(found.difference, 2);
  EXPECT_EQ(found.middle, 19);
}

TEST(WaterColumn, ReadingsBeforeTheLegDoNotCount) {
  const WaterColumn column = columnOf({{10, 5, 20}, {20, 6, 18}, {30, 7, 17}});
  EXPECT_EQ(column.steepest(10, 10).difference, 3);
  EXPECT_EQ(column.steepest(10, 10.5).difference, 1);
  EXPECT_EQ(column.steepest(10, 20).difference, 1) << "that of the very moment counts";
  EXPECT_TRUE(column.crossing(19, 10).found);
  EXPECT_FALSE(column.crossing(19, 10.5).found);
}

TEST(WaterColumn, TheNewestReadingOfAHalfMetreCounts) {
  const WaterColumn column = columnOf({{0, 5, 20}, {1, 5.4, 19}, {2, 6, 16}});
  EXPECT_EQ(column.steepest(10, 0).difference, 3);
  const WaterColumn next = columnOf({{0, 5, 20}, {1, 5.5, 19}, {2, 6, 16}});
  EXPECT_EQ(next.steepest(10, 0).difference, 4);
}

TEST(WaterColumn, AboveTheSurfaceIsTheSurface) {
  const WaterColumn column = columnOf({{0, -1, 20}, {1, 1, 16}});
  EXPECT_EQ(column.steepest(1, 0).difference, 4);
  const Crossing found = column.crossing(18, 0);
  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.depth, 0.5);
}

TEST(WaterColumn, RememberedAre16MetresUpAndDownFromTheNewest) {
  const auto difference = [](double other, double newest) {
    return columnOf({{0, other, 20}, {1, newest, 15}}).steepest(100, 0).difference;
  };
  EXPECT_EQ(difference(100, 116), 5);
  EXPECT_EQ(difference(100, 116.5), 0);
  EXPECT_EQ(difference(115.5, 100), 5);
  EXPECT_EQ(difference(116, 100), 0);
  const auto passes = [](double other, double newest) {
    const double between = other < newest ? other + 2 : newest + 2;
    const double step = other < newest ? 1 : -1;
    std::vector<At> readings;
    double time = 0;
    for (double depth = other; depth != newest; depth += step) {
      const bool first = other < newest ? depth < between : depth > other - 1;
      readings.push_back({time++, depth, first ? 20.0 : 15.0});
    }
    readings.push_back({time, newest, 15});
    return columnOf(readings).crossing(17, 0).found;
  };
  EXPECT_TRUE(passes(100, 116));
  EXPECT_TRUE(passes(115.5, 100.5));
  EXPECT_FALSE(passes(117, 100));
}

TEST(WaterColumn, AnOldReadingFarAwayIsNotTakenForAnother) {
  // The slot of 5 m is that of 37 m.
  const WaterColumn column = columnOf({{0, 5, 20}, {1, 37.5, 15}, {2, 38, 14}});
  EXPECT_EQ(column.steepest(100, 0).difference, 1);
}

TEST(WaterColumn, ACrossingLiesOnTheLineBetweenItsReadings) {
  const WaterColumn column = columnOf({{0, 5, 20}, {1, 6, 18}, {2, 8, 10}});
  const Crossing found = column.crossing(16, 0);
  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.depth, 6.5);
  EXPECT_EQ(column.crossing(18.5, 0).depth, 5.75);
  EXPECT_EQ(column.crossing(18, 0).depth, 6) << "at a reading";
  EXPECT_FALSE(column.crossing(20.5, 0).found);
  EXPECT_FALSE(column.crossing(9, 0).found);
  // Warmer below, as in winter.
  EXPECT_EQ(columnOf({{0, 5, 10}, {1, 6, 14}}).crossing(11, 0).depth, 5.25);
}

TEST(WaterColumn, ReadingsFarApartSayNothingOfTheWaterBetween) {
  EXPECT_TRUE(columnOf({{0, 5, 20}, {1, 8, 10}}).crossing(15, 0).found);
  EXPECT_FALSE(columnOf({{0, 5, 20}, {1, 8.5, 10}}).crossing(15, 0).found);
}

TEST(WaterColumn, OfSeveralCrossingsTheOneReadLastCounts) {
  const std::vector<At> down = {{0, 5, 20}, {1, 6, 10}, {2, 7, 20}};
  EXPECT_EQ(columnOf(down).crossing(15, 0).depth, 6.5);
  const std::vector<At> up = {{0, 7, 20}, {1, 6, 10}, {2, 5, 20}};
  EXPECT_EQ(columnOf(up).crossing(15, 0).depth, 5.5);
  // The older of its two readings says when it was read.
  const std::vector<At> mixed = {{0, 7, 20}, {5, 6, 10}, {3, 5, 20}};
  EXPECT_EQ(columnOf(mixed).crossing(15, 0).depth, 5.5);
}

}  // namespace
}  // namespace glider::runtime::testing
