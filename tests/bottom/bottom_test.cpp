// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Flights over bottoms that are drawn, with an altimeter that is wrong: how often the vehicle
// touches the bottom. scripts/soak/bottom flies more of the same and prints the table.

#include "simulator/sensors/noise.h"
#include "tests/bottom/bottom_faults.h"
#include "tests/bottom/bottom_flight.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace glider::tests {
namespace {

constexpr double kHours = 2;
constexpr double kGreatest = 60;  // max_depth, m
/// A contact is foretold by one this near, m, that was not this much deeper, m: of the altitude of
/// 5 m and the margin of 2 m that the vehicle keeps, turning takes up to 3 m.
constexpr double kNear = 3000;
constexpr double kMargin = 4;
/// So many echoes show an altimeter that receives few what it has to expect.
constexpr int kSomeEchoes = 3;

class Rng {
 public:
  explicit Rng(uint64_t seed)
      : noise_(seed, static_cast<uint32_t>(simulator::NoiseStream::Campaign)) {}
  double within(double low, double high) { return low + (high - low) * noise_.uniform(); }
  bool chance(double share) { return noise_.uniform() < share; }

 private:
  simulator::Noise noise_;
};

const std::map<std::string, std::function<void(simulator::BottomSettings&, Rng&, double)>>&
bottoms() {
  static const std::map<std::string, std::function<void(simulator::BottomSettings&, Rng&, double)>>
      kBottoms = {
          {"shelf", [](auto& bottom, Rng& dice, double) { bottom.depth_m = dice.within(25, 55); }},
          {"slope",
           [](auto& bottom, Rng& dice, double heading) {
             bottom.depth_m = dice.within(45, 110);
             bottom.slope = dice.within(0.002, 0.04);
             const double aside = dice.within(-1, 1);
             bottom.slope_bearing_rad =
                 std::remainder(heading + std::numbers::pi + aside, 2 * std::numbers::pi);
           }},
          {"seamount",
           [](auto& bottom, Rng& dice, double heading) {
             bottom.depth_m = dice.within(90, 160);
             const double away = dice.within(500, 1300), radius = dice.within(200, 700);
             const double top = dice.within(12, 45);
             bottom.seamounts.push_back({away * std::sin(heading), away * std::cos(heading), radius,
                                         bottom.depth_m - top});
           }},
          {"rough",
           [](auto& bottom, Rng& dice, double) {
             bottom.depth_m = dice.within(35, 90);
             bottom.wave_length_m = dice.within(300, 2000);
             bottom.wave_height_m =
                 std::min(bottom.depth_m - 22, bottom.wave_length_m * dice.within(0.002, 0.025));
           }},
      };
  return kBottoms;
}

/// The flight with this number.
OverBottom fly(const AltimeterFault& fault, const std::string& shape, uint64_t number,
               bool prints = false) {
  Rng dice(number);
  const double heading = dice.within(0, 2 * std::numbers::pi);
  std::string skeleton = hookbehSkeleton(kGreatest);
  if (fault.unread) {
    skeleton = "behavior: sensors_in\n b_arg: c_alt_time(sec) -1\n" + skeleton;
  }
  simulator::Scenario scenario = diveScenario(skeleton, 100);
  scenario.duration_s = kHours * 3600;
  scenario.vehicle.initial_heading_rad = heading;
  bottoms().at(shape)(scenario.ocean.bottom, dice, heading);
  scenario.ocean.wave.amplitude_m = dice.within(0, 3);
  scenario.sensors.depth.noise_m = dice.within(0.005, 0.1);
  if (dice.chance(0.3)) {
    scenario.sensors.ctd.dropout = 1;
  }
  Plan plan;
  plan.top_m = dice.within(3, 8);
  plan.bottom_m = dice.within(45, 56);
  plan.pitch_rad = dice.within(0.35, 0.6);
  plan.hovers = dice.chance(0.15);
  fault.apply(scenario, dice.chance(0.5) ? 0 : dice.within(300, 2400));
  const OverBottom flown = flyOverBottom(plan, std::move(scenario), number);
  if (prints) {
    fmt::print(
        "  {} over {}, flight {} ({} {:.1f} m): {} contacts, {:.0f} s on the bottom, clearance "
        "{:.1f} m, "
        "deepest {:.1f} m, {} dives, {} guarded cycles\n",
        fault.name, shape, number, plan.hovers ? "hover" : "yo", plan.bottom_m,
        flown.contacts.size(), flown.on_bottom_s, flown.clearance_m, flown.deepest_m, flown.dives,
        flown.guarded);
    for (const Contact& c : flown.contacts) {
      fmt::print("    {:.0f} s at {:.0f}, {:.0f} m: {:.1f} m deep for {:.0f} s\n", c.time_s,
                 c.east_m, c.north_m, c.depth_m, c.lasts_s);
    }
  }
  return flown;
}

/// What came of the flights of one fault over one shape of bottom.
struct Tally {
  int flights = 0;
  int touched = 0;  ///< flights with a contact
  int contacts = 0;
  int turning = 0;       ///< contacts of a vehicle that turned by itself
  int repeated = 0;      ///< contacts where an earlier one had shown the bottom
  int warned = 0;        ///< contacts after some echoes
  double longest_s = 0;  ///< on the bottom in a flight

  void add(const OverBottom& flown) {
    ++flights;
    touched += !flown.contacts.empty();
    contacts += static_cast<int>(flown.contacts.size());
    for (const Contact& contact : flown.contacts) {
      turning += contact.lasts_s < kStopsSecs;
      warned += contact.echoes >= kSomeEchoes;
    }
    repeated += static_cast<int>(tests::repeated(flown.contacts, kNear, kMargin).size());
    longest_s = std::max(longest_s, flown.on_bottom_s);
  }
};

using Tallies = std::map<std::pair<std::string, std::string>, Tally>;

void print(const Tallies& tallies) {
  fmt::print(
      "| altimeter | bottom | flights | that touch it | contacts | while turning | again | after "
      "{} echoes | longest, s |\n|---|---|---|---|---|---|---|---|---|\n",
      kSomeEchoes);
  for (const auto& [key, t] : tallies) {
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {:.0f} |\n", key.first, key.second,
               t.flights, t.touched, t.contacts, t.turning, t.repeated, t.warned, t.longest_s);
  }
}

TEST(Bottom, IsTouchedNoMoreThanIsGuaranteed) {
  const uint64_t count = wantedNumber("GLIDER_BOTTOM_FLIGHTS", 60);
  const uint64_t seed = wantedNumber("GLIDER_BOTTOM_SEED", 1);
  const bool prints = wantedNumber("GLIDER_BOTTOM_PRINTS", 0) != 0;
  const auto& faults = altimeterFaults();
  Tallies tallies;
  std::map<BottomRule, int> flights, against;
  std::string which;
  for (uint64_t number = seed; number < seed + count; ++number) {
    const AltimeterFault& fault = faults[number % faults.size()];
    auto shape = bottoms().begin();
    std::advance(shape, number / faults.size() % bottoms().size());
    const OverBottom flown = fly(fault, shape->first, number, prints);
    Tally one;
    one.add(flown);
    tallies[{fault.name, shape->first}].add(flown);
    const bool broken = fault.rule == BottomRule::Never  ? one.contacts > 0
                        : fault.rule == BottomRule::Rare ? one.warned > 0
                                                         : one.repeated > 0;
    ++flights[fault.rule];
    against[fault.rule] += broken;
    if (broken) {
      which += fmt::format("{} over a {}, flight {}\n", fault.name, shape->first, number);
    }
  }
  // What hooks/hookbeh/README.md states.
  EXPECT_LE(against[BottomRule::Never], flights[BottomRule::Never] / 100) << which;
  EXPECT_LE(against[BottomRule::Rare], flights[BottomRule::Rare] / 50) << which;
  EXPECT_LE(against[BottomRule::Once], flights[BottomRule::Once] / 25) << which;
  if (prints || wantedNumber("GLIDER_BOTTOM_TABLE", 0) != 0) {
    print(tallies);
  }
}

}  // namespace
}  // namespace glider::tests
