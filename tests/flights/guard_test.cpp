// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Water shallower than what Figure 2 commands: hookbeh's guard ends the dives early, and the yos go
// on.

#include "tests/flights/flight.h"
#include "tests/support/replaced.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glider::tests {
namespace {

constexpr double kLeastAltitude = 5;  // min_altitude of skeleton.mi
/// What a turn takes: pump and pitch need some 20 s, at up to 0.2 m/s; and a cycle to see the echo.
constexpr double kTurn = 4;

/// `text` with `from` replaced by `to`.
/// Figure 2 in the default world over a bottom `water_depth` deep with bumps of `bump` m.
Flight flyOver(double water_depth, double bump) {
  const TemporaryFolder folder;
  (void)folder.write("skeleton.mi", slurp(project("scenarios/skeleton.mi")));
  std::string world = slurp(project("scenarios/default.toml"));
  world = replaced(world, "water_depth_m = 80.0", "water_depth_m = " + std::to_string(water_depth));
  world = replaced(world, "bottom_height_m = 4.0", "bottom_height_m = " + std::to_string(bump));
  world = replaced(world, "bottom_wavelength_m = 900.0", "bottom_wavelength_m = 300.0");
  const auto scenario = folder.write("shallow.toml", world);
  return fly(project("missions/figure2.mission") + " --scenario " + scenario.string());
}

/// The times at which the vehicle begins to sink through `depth`.
std::vector<double> divesThrough(const Flight& flight, double depth) {
  const auto time = flight.column("time");
  const auto at = flight.column("true_depth");
  std::vector<double> dives;
  for (size_t i = 1; i < at.size(); ++i) {
    if (at[i - 1] < depth && at[i] >= depth) {
      dives.push_back(time[i]);
    }
  }
  return dives;
}

void expectTheYosGoOn(const Flight& flight) {
  ASSERT_EQ(flight.outcome.status, 1) << flight.outcome.err;
  EXPECT_NE(flight.outcome.err.find("GL9375"), std::string::npos) << flight.outcome.err;
  EXPECT_TRUE(std::ranges::any_of(flight.events, [](const Event& e) {
    return e.what.find("too near the bottom") != std::string::npos;
  })) << "the water was not shallow enough for this test";
  const auto dives = divesThrough(flight, 12);
  ASSERT_GE(dives.size(), 4U);
  double last = 524;  // control is in s2 from here on: 5 to 20 m; s1, from 1500 to 2000 s, to 10 m
  for (const double dive : dives) {
    EXPECT_LT(dive - last, dive > 1500 ? 600 : 300) << "no dive after " << last << " s";
    last = std::max(last, dive);
  }
  EXPECT_GT(last, 2200) << "the mission ends at some 2500 s";
}

void expectClearance(const Flight& flight) {
  const auto depth = flight.column("true_depth");
  const auto water = flight.column("water_depth");
  for (size_t i = 0; i < depth.size(); ++i) {
    EXPECT_GE(water[i] - depth[i], kLeastAltitude - kTurn) << "row " << i;
  }
}

TEST(Guarded, AYoGoesOnOverAShallowBottom) {
  const Flight flight = flyOver(22, 0);
  expectTheYosGoOn(flight);
  expectClearance(flight);
}

TEST(Guarded, AYoGoesOnOverBumps) {
  const Flight flight = flyOver(26, 4);
  expectTheYosGoOn(flight);
  expectClearance(flight);
}

}  // namespace
}  // namespace glider::tests
