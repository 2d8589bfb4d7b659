// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The shipped worlds, flown by a yo: what is special in each is there to be met.

#include "tests/unit/simulator/fake_sbc.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glider::simulator {
namespace {

SimulationSetup yoSetup(const std::string& scenario, double duration_s, double bottom_m = 25) {
  SimulationSetup setup = shippedSetup(scenario);
  const FakePilot::Plan plan{.top_m = 5, .bottom_m = bottom_m};
  setup.sbc = std::make_unique<FakeSbc>(plan);
  setup.mission_name = "fake";
  setup.state_names = {"down", "up"};
  setup.explain = [](uint32_t, uint32_t, uint32_t) { return GuardText{}; };
  setup.duration_s = duration_s;
  return setup;
}

support::Trace yo(const std::string& scenario, double duration_s, double bottom_m = 25) {
  return fly(yoSetup(scenario, duration_s, bottom_m));
}

std::vector<double> columnOf(const support::Trace& trace, const char* name) {
  std::vector<double> values;
  const int column = trace.column(name);
  EXPECT_GE(column, 0) << name;
  for (size_t row = 0; column >= 0 && row < trace.rowCount(); ++row) {
    values.push_back(trace.at(row, column));
  }
  return values;
}

/// Of the readings that there are.
double greatest(const std::vector<double>& values) {
  double most = -INFINITY;
  for (const double value : values) {
    most = value > most ? value : most;
  }
  return most;
}

double least(const std::vector<double>& values) {
  double least = INFINITY;
  for (const double value : values) {
    least = value < least ? value : least;
  }
  return least;
}

/// The detector that failed at sea: a window of readings that restarts whenever the temperature
/// stops changing in its direction. Says the greatest change (degC) within `length_m` that it sees.
double naiveDetector(const support::Trace& trace, double length_m) {
  const auto depth = columnOf(trace, "m_depth");
  const auto temperature = columnOf(trace, "sci_water_temp");
  double greatest = 0;
  size_t begin = 1;
  for (size_t i = 2; i < depth.size(); ++i) {
    const bool dives = depth[i] > depth[i - 1];
    const bool goes_on =
        dives ? temperature[i] < temperature[i - 1] : temperature[i] > temperature[i - 1];
    if (!goes_on) {
      begin = i;
    }
    while (std::fabs(depth[i] - depth[begin]) > length_m) {
      ++begin;
    }
    greatest = std::max(greatest, std::fabs(temperature[i] - temperature[begin]));
  }
  return greatest;
}

TEST(FirstDeployment, FailsADetectorThatNeedsMonotonicReadings) {
  SimulationSetup calm = yoSetup("first_deployment", 1200);
  calm.scenario.sensors.ctd = {};
  EXPECT_GT(naiveDetector(fly(std::move(calm)), 10), 10.5) << "the thermocline is there";
  for (const uint64_t seed : {61U, 1U, 2U, 3U, 4U}) {
    SimulationSetup rough = yoSetup("first_deployment", 1200);
    rough.seed = seed;
    const support::Trace trace = fly(std::move(rough));
    EXPECT_LT(naiveDetector(trace, 10), 10.5) << seed;
    EXPECT_GT(greatest(columnOf(trace, "sci_water_temp")), 22);
    EXPECT_LT(least(columnOf(trace, "sci_water_temp")), 12);
  }
}

TEST(Figure6, LosesOneClimbAndNoMore) {
  const support::Trace trace = yo("figure6", 1600);
  const auto time = columnOf(trace, "time");
  const auto depth = columnOf(trace, "true_depth");
  const auto read = columnOf(trace, "sci_water_temp");
  int lost = 0, good = 0;
  double lost_at = 0;
  size_t turn = 0;  // the deepest place since the last climb
  for (size_t i = 1; i < depth.size(); ++i) {
    turn = depth[i] > depth[turn] ? i : turn;
    if (depth[turn] > 20 && depth[i] < 8 && depth[i - 1] >= 8) {
      const bool warm = read[i] - read[turn] > 8;
      (warm ? good : lost) += 1;
      lost_at = warm ? lost_at : time[turn];
      turn = i;
    }
  }
  EXPECT_EQ(lost, 1);
  EXPECT_GE(good, 3);
  EXPECT_NEAR(lost_at, 700, 150);
}

TEST(ShelfSlope, HasASeamountThatTheAltimeterMeets) {
  const support::Trace trace = yo("shelf_slope", 4000, 20);
  const auto altitude = columnOf(trace, "m_altitude");
  const auto depth = columnOf(trace, "true_depth");
  const auto water = columnOf(trace, "water_depth");
  size_t heard = 0, lost_in_reach = 0;
  for (size_t i = 0; i < altitude.size(); ++i) {
    const double truth = water[i] - depth[i];
    if (!std::isnan(altitude[i])) {
      ++heard;
      EXPECT_NEAR(altitude[i], truth, 0.6);
      EXPECT_LE(altitude[i], 40);
    } else {
      lost_in_reach += truth < 39 && depth[i] > 2 ? 1U : 0U;
    }
  }
  EXPECT_GT(heard, 100U);
  EXPECT_NEAR(static_cast<double>(lost_in_reach) / static_cast<double>(heard), 0.11, 0.05);
  EXPECT_LT(least(water), 32) << "over the seamount";
  EXPECT_GT(water.back(), 50) << "the shelf falls away";
}

TEST(Bloom, HasAPatchEastOfTheStart) {
  const support::Trace trace = yo("bloom", 4000, 20);
  const auto chlorophyll = columnOf(trace, "sci_flbbcd_chlor_units");
  EXPECT_NEAR(valueAt(trace, "sci_flbbcd_chlor_units", 4), 0.4, 0.1);
  EXPECT_GT(greatest(chlorophyll), 6);
  const auto at = std::ranges::find(chlorophyll, greatest(chlorophyll)) - chlorophyll.begin();
  EXPECT_NEAR(trace.at(static_cast<size_t>(at), trace.column("true_x")), 600, 250);
  const auto oxygen = columnOf(trace, "sci_oxy4_oxygen");
  EXPECT_GT(greatest(oxygen), 255);
  EXPECT_LT(least(oxygen), 180);
}

TEST(LowBattery, FallsBelowElevenVoltsForGoodInTwoHours) {
  const support::Trace trace = yo("low_battery", 9000);
  EXPECT_GT(valueAt(trace, "m_battery", 3600), 11);
  EXPECT_LT(valueAt(trace, "m_battery", 7300), 11);
  EXPECT_LT(valueAt(trace, "m_battery", 9000), 11);
  SimulationSetup alone = shippedSetup("low_battery");
  alone.duration_s = 9000;
  EXPECT_GT(valueAt(fly(std::move(alone)), "m_battery", 9000), 11) << "the SBC is what empties it";
}

TEST(Front, IsColderBeyond) {
  const support::Trace trace = yo("front", 4000);
  const auto x = columnOf(trace, "true_x");
  const auto depth = columnOf(trace, "true_depth");
  const auto read = columnOf(trace, "sci_water_temp");
  double before = 0, beyond = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    if (depth[i] < 8) {
      before = x[i] < 300 ? std::max(before, read[i]) : before;
      beyond = x[i] > 1000 ? std::max(beyond, read[i]) : beyond;
    }
  }
  EXPECT_NEAR(before, 22, 0.5);
  EXPECT_NEAR(beyond, 16, 0.5);
}

TEST(Worlds, AreTheSameForASeed) {
  for (const char* name :
       {"bloom", "figure6", "first_deployment", "front", "low_battery", "shelf_slope"}) {
    const std::string once = traceToCsv(yo(name, 800));
    EXPECT_EQ(once, traceToCsv(yo(name, 800))) << name;
    SimulationSetup other = yoSetup(name, 800);
    other.seed = 4711;
    EXPECT_NE(once, traceToCsv(fly(std::move(other)))) << name;
  }
}

}  // namespace
}  // namespace glider::simulator
