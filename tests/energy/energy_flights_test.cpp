// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// No flight takes more from the batteries than energyBoundOf says: the missions of the gallery and
// the paper in random seas, on vehicles whose devices take as much as their spreads allow.
// scripts/soak/energy flies more of the same, and says how near they came.

#include "ir/prove/falsification/rng.h"
#include "tests/energy/watched_energy.h"
#include "tests/world/fleet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using ir::prove::EnergyBound;
using ir::prove::Rng;

/// A mission, its bound, and the flight that took the most.
struct Judged {
  FlyingMission mission;
  EnergyBound bound;
  FlownEnergy worst;
  double nearest = 0;
};

std::vector<Judged> judgedMissions(uint64_t random, uint64_t seed) {
  std::vector<Judged> all;
  for (FlyingMission& mission : missions(random, seed)) {
    const auto bound = boundOfEnergy(mission, slocum(), usualBoardPower());
    EXPECT_TRUE(bound) << mission.name;
    all.push_back({std::move(mission), *bound, {}});
  }
  return all;
}

double medianOf(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// "gallery/front  25.3 Wh of 108.2 in a flight of 3.1 h  4.28".
std::string rowOf(const Judged& one) {
  constexpr double kJoulesPerWh = 3600;
  const double bound_j = one.bound.joules.value_or(0);
  return fmt::format("{:<32} {:>8.2f} Wh {:>8.2f} Wh {:>6.2f} h {:>8.2f} {:>8.3f}\n",
                     std::filesystem::path(one.mission.name).stem().string(),
                     bound_j / kJoulesPerWh, one.worst.used_j / kJoulesPerWh,
                     one.worst.seconds / 3600, bound_j / one.worst.used_j, one.nearest);
}

TEST(EnergyBounds, NoFlightTakesMore) {
  constexpr uint64_t kFew = 60;
  const uint64_t count = wanted("GLIDER_ENERGY_FLIGHTS", kFew);
  const uint64_t seed = wanted("GLIDER_ENERGY_SEED", 1);
  std::vector<Judged> judged = judgedMissions(std::clamp<uint64_t>(count / 50, 4, 200), seed);
  const std::vector<simulator::Scenario> seas = scenarios();
  uint64_t in_control = 0;
  for (uint64_t i = seed; i < seed + count; ++i) {
    Judged& one = judged[i % judged.size()];
    Rng dice(i);
    const auto sea = drawSea(seas[i / judged.size() % seas.size()], one.bound, dice);
    const FlownEnergy flown = flyForEnergy(one.mission, one.bound, sea, i);
    in_control += flown.seconds > 0;
    EXPECT_LE(flown.nearest, 1) << "flight " << i << ": " << one.mission.name << " in " << sea.name;
    one.nearest = std::max(one.nearest, flown.nearest);
    if (flown.used_j > one.worst.used_j) {
      one.worst = flown;
    }
  }
  EXPECT_GT(in_control, count / 2);
  if (count > kFew) {
    std::vector<double> ratios;
    fmt::print("{:<32} {:>11} {:>11} {:>8} {:>8} {:>8}\n", "mission", "bound", "worst flight", "",
               "ratio", "nearest");
    for (const Judged& one : judged) {
      if (one.bound.joules && one.worst.used_j > 0) {
        fmt::print("{}", rowOf(one));
        ratios.push_back(*one.bound.joules / one.worst.used_j);
      }
    }
    fmt::print("{} flights, {} in control; bound over the worst flight, median: {:.2f}\n", count,
               in_control, medianOf(ratios));
  }
}

}  // namespace
}  // namespace glider::tests
