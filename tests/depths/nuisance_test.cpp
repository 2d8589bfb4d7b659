// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Flights of a whole vehicle in all kinds of water: no guard of hookbeh may come in, unless the
// water held a dive as the bottom does: internal waves that rise as fast as a vehicle with little
// lift sinks, and layers that it hangs on. scripts/soak/nuisance flies more of the same.

#include "simulator/sensors/noise.h"
#include "simulator/slocum/own_mission.h"
#include "tests/depths/depth_faults.h"
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
constexpr double kUnreachable = 1000;
constexpr double kHours = 1;

/// Of the pump's lift, what a layer of water and a bad trim may take away together: what is left
/// moves the vehicle at two fifths of its speed, which waves then stop and turn.
constexpr double kMostOfLift = 0.84;
/// The same without a CTD: seven tenths of its speed.
constexpr double kMostOfLiftAlone = 0.5;

/// A value of sensors_in: mostly each cycle, else one of the stock ones.
double drawPeriod(Rng& dice, std::initializer_list<double> stock) {
  const auto drawn = static_cast<size_t>(dice.within(0, static_cast<double>(stock.size())));
  return dice.chance(0.4) ? 0 : std::data(stock)[drawn];
}

/// The mission file's own reading of the devices, above hookbeh.
std::string drawSensorsIn(Rng& dice) {
  return fmt::format(
      "behavior: sensors_in\n b_arg: c_att_time(s) {}\n b_arg: c_pressure_time(s) {}\n"
      " b_arg: c_alt_time(s) {}\n b_arg: u_battery_time(s) {}\n",
      drawPeriod(dice, {2, 4, 10}), drawPeriod(dice, {2, 4, 5, 6, 8, 10, 12, 16}),
      drawPeriod(dice, {4, 10, 16}), drawPeriod(dice, {10, 60}));
}

/// Swell of up to a metre in the depth: of the whole water column, or as the pressure has it.
void drawSwell(Rng& dice, simulator::OceanSettings& ocean) {
  const double amplitude = dice.within(0, 1), period = dice.within(6, 14);
  if (dice.chance(0.3)) {
    ocean.wave = {amplitude, period, 0, dice.within(0, 6)};
  } else if (dice.chance(0.6)) {
    ocean.swell = {amplitude, period, dice.within(0, 6), dice.chance(0.5) ? 1 : dice.within(0, 1)};
  }
}

/// Cycles of 4 to 15 s.
void drawCycles(Rng& dice, simulator::CycleSettings& cycles) {
  if (dice.chance(0.6)) {
    cycles = {dice.within(4, 4.6), dice.within(0, 0.4), dice.chance(0.6) ? dice.within(0, 0.06) : 0,
              dice.within(6, 15)};
  }
}

/// Yos and hovers at the pitches and depths that pilots use.
Plan drawPlan(Rng& dice) {
  Plan plan;
  plan.top_m = dice.within(2, 8);
  // Above max_depth there must be room for what the dive overshoots, for rare readings and swell.
  plan.bottom_m = dice.within(12, 50);
  plan.pitch_rad = dice.within(0.32, 0.6);
  plan.hovers = dice.chance(0.25);
  plan.release_s = kHours * 3600;
  return plan;
}

simulator::Scenario drawWater(Rng& dice, double greatest_m) {
  std::string skeleton = hookbehSkeleton(greatest_m);
  skeleton.insert(skeleton.find("behavior: hookbeh"), drawSensorsIn(dice));
  simulator::Scenario scenario = diveScenario(skeleton, dice.within(85, 200));
  scenario.duration_s = kHours * 3600 + 1200;
  auto& ocean = scenario.ocean;
  ocean.thermocline_depth_m = dice.within(8, 35);
  ocean.thermocline_thickness_m = dice.within(1, 12);
  ocean.wave = {dice.within(0, 6), dice.within(300, 2400),
                dice.chance(0.5) ? 0 : dice.within(300, 2000), dice.within(0, 6)};
  drawSwell(dice, ocean);
  drawCycles(dice, scenario.cycles);
  const bool has_ctd = dice.chance(0.6);
  // Share of the lift that goes to stratification, and that to a bad trim.
  const double lift_kg = 0.233 * 1.025;
  const double lost = dice.within(0, has_ctd ? kMostOfLift : kMostOfLiftAlone),
               to_trim = dice.within(0, 0.4);
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
  if (!has_ctd) {
    scenario.faults.sensors.push_back(noCtd());
  }
  return scenario;
}

std::string describe(const simulator::Scenario& scenario) {
  std::string text;
  for (const auto& block : simulator::missionFileOf(scenario).behaviours) {
    if (block.name == "sensors_in") {
      text = fmt::format("c_pressure_time {} ", block.value("c_pressure_time"));
    }
  }
  const auto& ocean = scenario.ocean;
  return text + fmt::format(
                    "wave {:.2f} m {:.1f} s, swell {:.2f} m {:.1f} s followed {:.2f}, "
                    "cycles {:.2f} s, {:.3f} of {:.1f} s, {}, step {:.2f} kg/m3, noise {:.3f}",
                    ocean.wave.amplitude_m, ocean.wave.period_s, ocean.swell.amplitude_m,
                    ocean.swell.period_s, ocean.swell.followed_share, scenario.cycles.mean_s,
                    scenario.cycles.long_share, scenario.cycles.long_s,
                    scenario.faults.sensors.empty() ? "CTD" : "no CTD", ocean.density_step,
                    scenario.sensors.depth.noise_m);
}

TEST(Nuisance, NoGuardComesInWhereNothingIsWrong) {
  const uint64_t count = wantedNumber("GLIDER_NUISANCE_FLIGHTS", 40);
  const uint64_t seed = wantedNumber("GLIDER_NUISANCE_SEED", 1);
  uint64_t guarded = 0, held = 0, dives = 0, deep = 0;
  for (uint64_t i = 0; i < count; ++i) {
    Rng dice(seed + i);
    const Plan plan = drawPlan(dice);
    Rng again = dice;
    const simulator::Scenario drawn = drawWater(dice, kGreatest);
    const Dived dived = flyDive(&plan, drawn, seed + i);
    dives += static_cast<uint64_t>(dived.dives);
    deep += dived.deepest_m > 10;
    guarded += !dived.guards.empty();
    held += dived.water_held_it;
    if (dived.water_held_it) {
      fmt::print("flight {}{} {:.1f} m: guard {} at {:.0f} s after the water held a dive\n",
                 seed + i, plan.hovers ? ", hover at" : ", yo to", plan.bottom_m,
                 *dived.guards.begin(), dived.guarded_s);
    }
    EXPECT_TRUE(dived.guards.empty() || dived.water_held_it)
        << "flight " << seed + i << (plan.hovers ? ", hover at " : ", yo to ") << plan.bottom_m
        << " m at " << plan.pitch_rad << " rad: guard " << *dived.guards.begin() << " at "
        << dived.guarded_s << " s, deepest " << dived.deepest_m << " m\n"
        << describe(drawn);
    if (!plan.hovers && dived.guards.empty()) {
      const Dived free = flyDive(&plan, drawWater(again, kUnreachable), seed + i);
      EXPECT_EQ(dived.dives, free.dives) << "flight " << seed + i << ": hookbeh changes its yos";
    }
    if (count > 100 && (i + 1) % 200 == 0) {
      fmt::print("{} of {} flights, {} guarded, {} of them after the water held a dive, {} dives\n",
                 i + 1, count, guarded, held, dives);
      std::fflush(stdout);
    }
  }
  EXPECT_LE(held, count / 200) << "a dive that the water holds is rare";
  EXPECT_GT(deep, count * 9 / 10) << "they dived";
}

}  // namespace
}  // namespace glider::tests
