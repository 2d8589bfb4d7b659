// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The way home that `check --report` states: the SBC is killed at a random moment of a flight, and
// the vehicle is no deeper than stated and at the surface in the stated time, for good.

#include "vehicles/slocum/rules/way_home.h"

#include "flights/in_process_sbc.h"
#include "ir/prove/abstract/state_depths.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/falsification/rng.h"
#include "simulator/simulator.h"
#include "simulator/slocum/own_mission.h"
#include "tests/world/fleet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glider::tests {
namespace {

using flights::InProcessSbc;
using vehicles::WayHome;

/// Looks at where the vehicle is after the SBC's death.
class DeathWatch final : public simulator::FlightObserver {
 public:
  DeathWatch(double killed_s, std::vector<double> deepest)
      : killed_s_(killed_s), deepest_(std::move(deepest)) {}

  void said(std::span<const uint8_t>, double) override {}
  bool cycle(const simulator::CycleView& view) override {
    controlled_ = controlled_ || (view.time_s < killed_s_ && view.hook == hooks::HookState::Active);
    if (view.time_s < killed_s_) {
      return true;
    }
    const WayHome home = stated();
    const double surface_m = slocum().world.surface_depth_m;
    too_deep_ = too_deep_ || view.true_depth_m > home.depth_m;
    late_ = late_ || (view.time_s > killed_s_ + home.surface_s && view.true_depth_m > surface_m);
    if (view.true_depth_m > surface_m) {
      last_under_s_ = view.time_s;
    }
    constexpr double kMore = 300;  // s in which it must not go down again
    return view.time_s < killed_s_ + home.surface_s + kMore;
  }
  void polled(const GliderContext& context) {
    state_ = context.state;
    finished_ = context.finished != 0;
  }

  [[nodiscard]] WayHome stated() const {
    return slocum::rules::wayHomeFrom(deepest_.at(state_), slocum());
  }
  /// The SBC was in control when it died.
  [[nodiscard]] bool counts() const { return controlled_ && !finished_; }
  [[nodiscard]] bool tooDeep() const { return too_deep_; }
  [[nodiscard]] bool late() const { return late_; }
  /// The share of the stated time that it took.
  [[nodiscard]] double share() const {
    return std::max(0.0, last_under_s_ - killed_s_) / stated().surface_s;
  }

 private:
  double killed_s_;
  std::vector<double> deepest_;
  uint32_t state_ = 0;
  bool controlled_ = false, finished_ = false, too_deep_ = false, late_ = false;
  double last_under_s_ = 0;
};

DeathWatch flyAndKill(const FlyingMission& mission, const simulator::Scenario& scenario,
                      uint64_t seed) {
  ir::prove::Rng dice(seed);
  const Conditions conditions = drawConditions(mission.flown->mission, scenario, seed);
  constexpr double kLatest = 5400;  // s
  const double killed_s = dice.within(60, kLatest);
  DeathWatch watch(killed_s, ir::prove::deepestByState(
                                 ir::prove::ProofContext(mission.flown->mission, slocum())));
  simulator::SimulationSetup setup;
  setup.platform = slocum();
  setup.scenario = conditions.scenario;
  setup.scenario.faults = scenario.faults;  // this is enough
  setup.seed = seed;
  setup.duration_s = 2 * kLatest;
  setup.kill_sbc_at_s = killed_s;
  setup.observer = &watch;
  auto sbc = std::make_unique<InProcessSbc>(mission.loaded, conditions.parameters,
                                            std::make_shared<flights::Card>(), true);
  sbc->watch([&](const GliderContext& context, double) { watch.polled(context); });
  setup.sbc = std::move(sbc);
  EXPECT_TRUE(simulator::simulate(std::move(setup)).has_value());
  return watch;
}

TEST(WayHome, OfAKilledSbcIsNoLongerThanStated) {
  constexpr uint64_t kFew = 60;
  const uint64_t count = wanted("GLIDER_WORLD_FLIGHTS", kFew);
  const auto all = missions(6, 1);
  auto worlds = scenarios();
  // If the layered control flies a yo without the SBC, that was intended.
  std::erase_if(worlds, [](const auto& world) {
    return std::ranges::any_of(simulator::missionFileOf(world).behaviours,
                               [](const auto& behaviour) { return behaviour.name == "yo"; });
  });
  uint64_t counted = 0;
  double longest = 0;
  for (uint64_t i = 0; i < count; ++i) {
    const FlyingMission& mission = all[i % all.size()];
    const auto& world = worlds[i / all.size() % worlds.size()];
    const DeathWatch watch = flyAndKill(mission, world, i + 1);
    counted += watch.counts();
    longest = watch.counts() ? std::max(longest, watch.share()) : longest;
    if (watch.counts()) {
      EXPECT_FALSE(watch.tooDeep()) << mission.name << " in " << world.name << ", seed " << i + 1;
      EXPECT_FALSE(watch.late()) << mission.name << " in " << world.name << ", seed " << i + 1;
    }
  }
  EXPECT_GT(counted, count / 3);
  EXPECT_GT(longest, 0.02) << "none was under water";
  fmt::print(
      "{} of {} flights killed in control; the longest way home took {:.2f} of what is stated\n",
      counted, count, longest);
}

/// The sum is of the platform's numbers and hookbeh's silence: a vehicle that took longer is seen.
TEST(WayHome, IsTheSumOfItsParts) {
  const WayHome home = slocum::rules::wayHomeFrom(31, slocum());
  EXPECT_EQ(home.depth_m, 31);
  EXPECT_NEAR(home.surface_s, 24 + 2 * 20 + 8 + 120 + 31 / 0.05, 1e-9);
  EXPECT_TRUE(std::isinf(slocum::rules::wayHomeFrom(INFINITY, slocum()).surface_s));
}

}  // namespace
}  // namespace glider::tests
