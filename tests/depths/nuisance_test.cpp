// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Flights of a whole vehicle in all kinds of water: no guard of hookbeh may come in.
// scripts/soak/nuisance flies more of the same.

#include "simulator/sensors/noise.h"
#include "tests/depths/depth_flight.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace glider::tests {
namespace {

/// What is drawn for one flight.
class Rng {
 public:
  explicit Rng(uint64_t seed)
      : noise_(seed, static_cast<uint32_t>(simulator::NoiseStream::Campaign)) {}
  double within(double low, double high) { return low + (high - low) * noise_.uniform(); }
  bool chance(double share) { return noise_.uniform() < share; }

 private:
  simulator::Noise noise_;
};

constexpr double kGreatest = 60;  // max_depth, m
constexpr double kHours = 1;

/// Of the pump's lift, what a layer of water and a bad trim may take away together: what is left
/// moves the vehicle at two fifths of its speed, which waves then stop and turn.
constexpr double kMostOfLift = 0.84;

/// Yos and hovers at the pitches and depths that pilots use.
Plan drawPlan(Rng& dice) {
  Plan plan;
  plan.top_m = dice.within(2, 8);
  plan.bottom_m = dice.within(12, 56);
  plan.pitch_rad = dice.within(0.32, 0.6);
  plan.hovers = dice.chance(0.25);
  plan.release_s = kHours * 3600;
  return plan;
}

simulator::Scenario drawWater(Rng& dice) {
  simulator::Scenario scenario = diveScenario(hookbehSkeleton(kGreatest), dice.within(75, 200));
  scenario.duration_s = kHours * 3600 + 1200;
  auto& ocean = scenario.ocean;
  ocean.thermocline_depth_m = dice.within(8, 35);
  ocean.thermocline_thickness_m = dice.within(1, 12);
  ocean.wave = {dice.within(0, 6), dice.within(300, 2400),
                dice.chance(0.5) ? 0 : dice.within(300, 2000), dice.within(0, 6)};
  // Share of the lift that goes to stratification, and that to a bad trim.
  const double lift_kg = 0.233 * 1.025;
  const double lost = dice.within(0, kMostOfLift), to_trim = dice.within(0, 0.4);
  const double volume = 65.0 / 1025;
  ocean.density_step = 2 * lost * (1 - to_trim) * lift_kg / volume;
  scenario.vehicle.flight.mass_kg += (dice.chance(0.5) ? 1 : -1) * lost * to_trim * lift_kg;
  scenario.vehicle.flight.drag = dice.within(0.10, 0.20);
  scenario.vehicle.initial_heading_rad = dice.within(0, 2 * std::numbers::pi);
  scenario.sensors.depth.noise_m = dice.within(0.005, 0.1);
  scenario.sensors.ctd.late_s = dice.chance(0.5) ? 0 : dice.within(0, 4);
  scenario.sensors.ctd.repeat_fraction = dice.chance(0.5) ? 0 : 0.2;
  scenario.sensors.ctd.dropout = dice.chance(0.5) ? 0 : 0.3;
  if (dice.chance(0.25)) {  // Figure 6: climbs on which the CTD keeps its water
    scenario.sensors.ctd.stale_climbs = {.on = true, .frozen_s = 1000, .after_s = 600, .count = 1};
  }
  return scenario;
}

TEST(Nuisance, NoGuardComesInWhereNothingIsWrong) {
  const uint64_t count = wantedNumber("GLIDER_NUISANCE_FLIGHTS", 40);
  const uint64_t seed = wantedNumber("GLIDER_NUISANCE_SEED", 1);
  uint64_t guarded = 0, dives = 0, deep = 0;
  for (uint64_t i = 0; i < count; ++i) {
    Rng dice(seed + i);
    const Plan plan = drawPlan(dice);
    const Dived dived = flyDive(&plan, drawWater(dice), seed + i);
    dives += static_cast<uint64_t>(dived.dives);
    deep += dived.deepest_m > 10;
    guarded += !dived.guards.empty();
    EXPECT_TRUE(dived.guards.empty())
        << "flight " << seed + i << (plan.hovers ? ", hover at " : ", yo to ") << plan.bottom_m
        << " m at " << plan.pitch_rad << " rad: guard " << *dived.guards.begin() << " at "
        << dived.guarded_s << " s, deepest " << dived.deepest_m << " m";
    if (count > 100 && (i + 1) % 200 == 0) {
      fmt::print("{} of {} flights, {} guarded, {} dives\n", i + 1, count, guarded, dives);
      std::fflush(stdout);
    }
  }
  EXPECT_GT(deep, count * 9 / 10) << "they dived";
}

}  // namespace
}  // namespace glider::tests
