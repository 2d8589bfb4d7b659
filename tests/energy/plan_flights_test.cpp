// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What `glidercc plan` chooses flies as it promises: no flight of a plan takes more energy than the
// bound by which it was chosen. scripts/soak/plans flies a thousand.

#include "analysis/plan/plan_mission.h"
#include "tests/energy/watched_energy.h"
#include "tests/plan/problems.h"
#include "tests/world/fleet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

struct Planned {
  FlyingMission mission;
  ir::prove::EnergyBound bound;
};

Planned planOf(const Problem& problem) {
  const auto compiled = compiler::compileText("m.mission", openText(problem));
  EXPECT_TRUE(compiled) << problem.name;
  analysis::CheckObserver silent;
  const auto planned = analysis::planMission("m.mission", *compiled, {}, silent);
  EXPECT_TRUE(planned && planned->plan.chosen) << problem.name;
  auto mission = loadMission(problem.name + ".mission", planned->text);
  EXPECT_TRUE(mission) << planned->text;
  const auto bound = boundOfEnergy(*mission, slocum(), usualBoardPower());
  EXPECT_TRUE(bound) << planned->text;
  return {std::move(*mission), *bound};
}

TEST(PlanFlights, TakeNoMoreThanThePlanSays) {
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  const uint64_t count = wanted("GLIDER_PLAN_FLIGHTS", 22);
  const uint64_t seed = wanted("GLIDER_PLAN_SEED", 1);
  std::vector<Planned> plans;
  for (const Problem& problem : planProblems()) {
    plans.push_back(planOf(problem));
  }
  const simulator::Scenario deep = deepSea();
  uint64_t in_control = 0;
  double nearest = 0;
  for (uint64_t i = seed; i < seed + count; ++i) {
    const Planned& one = plans[i % plans.size()];
    ir::prove::Rng dice(i);
    const auto sea = drawSea(deep, one.bound, dice);
    const FlownEnergy flown = flyForEnergy(one.mission, one.bound, sea, i);
    in_control += flown.seconds > 0;
    EXPECT_LE(flown.nearest, 1) << "flight " << i << ": " << one.mission.name << " in " << sea.name;
    nearest = std::max(nearest, flown.nearest);
  }
  EXPECT_EQ(in_control, count);
  EXPECT_GT(nearest, 0.3) << "flights that say little of the bound";
  if (count > 22) {
    fmt::print("{} flights of plans, {} in control; nearest to a bound: {:.3f} of it\n", count,
               in_control, nearest);
  }
}

}  // namespace
}  // namespace glider::tests
