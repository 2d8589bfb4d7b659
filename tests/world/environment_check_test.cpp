// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The check of flights detects each broken rule: a flight that keeps all, and the same flight with
// one number wrong.

#include "tests/world/environment_check.h"

#include "platforms/load/longest_lag.h"
#include "runtime/core/control.h"
#include "tests/world/fleet.h"

#include <gtest/gtest.h>

#include <functional>

namespace glider::tests {
namespace {

constexpr double kCycle = 4;  // s

/// Down to 20 m, over it by `beyond`, up again, at plain speeds.
struct CheckedFlight {
  double sinks_mps = 0.2, climbs_mps = 0.15;
  double start_m = 0;
  double beyond_m = 4;    ///< how far it goes past the command
  double turns_s = 60;    ///< after the command to climb
  double stops_at_m = 0;  ///< on its way up
  double floats_at_m = 0.2;
  double reading_off_m = 0.1;
  double tick_s = kCycle;
  double pressure_bar = 3;
  double drift_mps = 0.3;
  double gets_on_mps = 0.4;
  double floats_mps = 0.5;
  double top_m = 0;  ///< it climbs so high

  [[nodiscard]] EnvironmentCheck fly() const {
    EnvironmentCheck world(slocum());
    world.begin(0, start_m, true);
    double time = 0, depth = start_m;
    const auto move = [&](double speed) {
      time += kCycle;
      depth += speed * kCycle;
      world.moved(time, depth);
    };
    world.commandDown(20, depth);
    while (depth + sinks_mps * kCycle <= 20 + beyond_m) {
      move(sinks_mps);
      world.commandDown(20, depth);
    }
    const double turned = time + turns_s;
    while (depth > stops_at_m + 1 && time < 5000) {
      world.commandUp(0, depth, time);
      move(time >= turned ? -climbs_mps : 0);
    }
    for (int i = 0; i < 200; ++i) {
      world.commandUp(0, depth, time);
      depth = stops_at_m > 0 ? depth : top_m;
      world.moved(time += kCycle, depth);
    }
    others(world, time);
    return world;
  }

  void others(EnvironmentCheck& world, double time) const {
    world.floats(time, floats_at_m);
    world.sees(time, 10 + reading_off_m, 10);
    world.ticks(time);
    world.ticks(time + tick_s);
    world.reports(time, *slocum().find("m_pressure"), pressure_bar);
    world.drifts(time, drift_mps);
    world.getsOn(time, gets_on_mps);
    world.floatsAlong(time, floats_mps);
  }
};

TEST(EnvironmentCheck, AnInstructionIsLeftAloneAsLongAsTheLineMayNeed) {
  EXPECT_EQ(runtime::Control::kObeyedTicks, platforms::kLongestLagCycles + 1);
}

TEST(EnvironmentCheck, AFlightThatKeepsAllIsFineAndEachRuleIsLookedAt) {
  const EnvironmentCheck world = CheckedFlight{}.fly();
  EXPECT_FALSE(world.broken().has_value()) << world.broken()->what;
  for (const Rule rule : kAllRules) {
    EXPECT_GT(world.use(rule).looks, 0U) << nameOf(rule);
  }
}

struct Planted {
  Rule rule;
  std::function<void(CheckedFlight&)> plant;
  friend void PrintTo(const Planted& planted, std::ostream* out) { *out << nameOf(planted.rule); }
};

class Violation : public testing::TestWithParam<Planted> {};

TEST_P(Violation, IsSeen) {
  CheckedFlight flight;
  GetParam().plant(flight);
  const EnvironmentCheck world = flight.fly();
  ASSERT_TRUE(world.broken().has_value());
  EXPECT_EQ(world.broken()->rule, GetParam().rule) << world.broken()->what;
}

// Each number is just beyond the platform file's.
INSTANTIATE_TEST_SUITE_P(
    , Violation,
    testing::Values(Planted{Rule::Rate, [](CheckedFlight& f) { f.sinks_mps = 0.41; }},
                    Planted{Rule::Rate, [](CheckedFlight& f) { f.climbs_mps = 0.41; }},
                    Planted{Rule::Deepest, [](CheckedFlight& f) { f.beyond_m = 5.9; }},
                    Planted{Rule::Climb, [](CheckedFlight& f) { f.climbs_mps = 0.04; }},
                    Planted{Rule::Climb, [](CheckedFlight& f) { f.turns_s = 500; }},
                    Planted{Rule::Climb, [](CheckedFlight& f) { f.stops_at_m = 6; }},
                    Planted{Rule::Above, [](CheckedFlight& f) { f.top_m = -0.1; }},
                    Planted{Rule::Start, [](CheckedFlight& f) { f.start_m = 3.1; }},
                    Planted{Rule::Surface, [](CheckedFlight& f) { f.floats_at_m = 2.1; }},
                    Planted{Rule::Reading, [](CheckedFlight& f) { f.reading_off_m = -0.91; }},
                    Planted{Rule::TickGap, [](CheckedFlight& f) { f.tick_s = 20.5; }},
                    Planted{Rule::Range, [](CheckedFlight& f) { f.pressure_bar = -1.1; }},
                    Planted{Rule::Drift, [](CheckedFlight& f) { f.drift_mps = 0.51; }},
                    Planted{Rule::ThroughWater, [](CheckedFlight& f) { f.gets_on_mps = 0.61; }},
                    Planted{Rule::SurfaceDrift, [](CheckedFlight& f) { f.floats_mps = 0.81; }}));

/// A command to climb that comes on the way down stops the dive: 5 m after it is obeyed, before
/// which the vehicle sinks on at 0.4 m/s for the 12 s of the line and a cycle.
TEST(EnvironmentCheck, ACommandToClimbStopsADive) {
  const auto sinksOn = [](double metres) {
    EnvironmentCheck world(slocum());
    world.begin(0, 0, true);
    world.commandDown(50, 0);
    double time = 0, depth = 0;
    for (; depth < 20; time += kCycle, depth += 0.8) {
      world.moved(time, depth);
    }
    world.moved(time, depth);
    world.commandUp(5, depth, time);
    for (const double end = depth + metres; depth + 0.8 <= end;) {
      world.moved(time += kCycle, depth += 0.8);
    }
    return world;
  };
  EXPECT_FALSE(sinksOn(14.4).broken().has_value());
  ASSERT_TRUE(sinksOn(15.3).broken().has_value());
  EXPECT_EQ(sinksOn(15.3).broken()->rule, Rule::Deepest);
}

}  // namespace
}  // namespace glider::tests
