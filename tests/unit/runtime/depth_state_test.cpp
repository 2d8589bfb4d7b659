// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// How long the vehicle's last report that it dives, or climbs, counts by its port.

#include "runtime/extctl/depth_state.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::runtime::extctl {
namespace {

constexpr double kOnSurface = 0, kDives = 1, kClimbs = 2, kHovers = 3;

/// Reported at 20 m at 0 s; then a cycle every 4 s with the depth of `depth_of`. Returns when it
/// was last known, s, of 400 s.
template <typename Depth>
double knownUntil(double state, Depth depth_of) {
  DepthState held;
  held.look(depth_of(0), 0);
  held.report(state);
  double known_s = -1;
  for (double now = 4; now <= 400; now += 4) {
    held.look(depth_of(now), now);
    if (held.state() == state) {
      EXPECT_TRUE(known_s < 0 || known_s == now - 4) << "it came back at " << now;
      known_s = now;
    } else {
      EXPECT_TRUE(std::isnan(held.state()));
    }
  }
  return known_s;
}

TEST(DepthState, GoesOnWhileTheVehicleMovesSo) {
  EXPECT_EQ(knownUntil(kDives, [](double s) { return 20 + 0.02 * s; }), 400);
  EXPECT_EQ(knownUntil(kClimbs, [](double s) { return 90 - 0.02 * s; }), 400);
  EXPECT_EQ(knownUntil(kOnSurface, [](double s) { return 0.5 + std::sin(s); }), 400);
}

/// Swell of 1 m, and a dive between.
TEST(DepthState, SwellContradictsNothing) {
  EXPECT_EQ(knownUntil(kDives, [](double s) { return 20 + 0.1 * s + std::sin(s / 1.5); }), 400);
  EXPECT_EQ(knownUntil(kClimbs, [](double s) { return 90 - 0.1 * s + std::sin(s / 1.5); }), 400);
}

TEST(DepthState, EndsWhereTheVehicleTurns) {
  // 20 m, 40 m at 100 s, 37 m at 115 s.
  const auto yo = [](double s) { return s < 100 ? 20 + 0.2 * s : 40 - 0.2 * (s - 100); };
  EXPECT_EQ(knownUntil(kDives, yo), 112);
  EXPECT_EQ(knownUntil(kClimbs, [&](double s) { return 60 - yo(s); }), 112);
  EXPECT_EQ(knownUntil(kOnSurface, [](double s) { return 0.1 * s; }), 48);
}

TEST(DepthState, EndsWhereTheVehicleStops) {
  EXPECT_EQ(knownUntil(kDives, [](double s) { return std::min(20 + 0.2 * s, 30.0); }), 108);
  EXPECT_EQ(knownUntil(kClimbs, [](double s) { return std::max(10 - 0.2 * s, 0.0); }), 108);
}

/// A Slocum reports it there.
TEST(DepthState, TheSurfaceBeginsAtFourMetres) {
  EXPECT_EQ(knownUntil(kOnSurface, [](double s) { return std::max(4 - 0.2 * s, 0.1); }), 400);
}

TEST(DepthState, AClockThatGoesBackEndsIt) {
  DepthState held;
  held.look(20, 5000);
  held.report(kDives);
  held.look(21, 5004);
  EXPECT_EQ(held.state(), kDives);
  held.look(21.5, 1000);
  EXPECT_TRUE(std::isnan(held.state()));
}

TEST(DepthState, WithoutADepthNothingGoesOn) {
  EXPECT_EQ(knownUntil(kOnSurface, [](double s) { return s == 40 ? NAN : 0.5; }), 36);
  DepthState held;
  held.report(kDives);
  EXPECT_TRUE(std::isnan(held.state())) << "no depth was reported";
}

/// Nothing shows that a vehicle that hovered still does.
TEST(DepthState, OtherValuesNeverGoOn) {
  EXPECT_EQ(knownUntil(kHovers, [](double) { return 20; }), -1);
  EXPECT_EQ(knownUntil(99, [](double) { return 20; }), -1);
  EXPECT_EQ(knownUntil(-1, [](double) { return 20; }), -1);
}

}  // namespace
}  // namespace glider::runtime::extctl
