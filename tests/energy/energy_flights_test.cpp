// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// No flight takes more from the batteries than energyBoundOf says: the missions of the gallery and
// the paper in random seas, on vehicles whose devices take as much as their spreads allow.
// scripts/soak/energy flies more of the same, and says how near they came.

#include "compiler/boards.h"
#include "flights/in_process_sbc.h"
#include "hooks/hookbeh/hookbeh.h"
#include "hooks/protocol/values.h"
#include "ir/eval/interpreter.h"
#include "ir/prove/energy/energy_bound.h"
#include "ir/prove/falsification/rng.h"
#include "simulator/simulator.h"
#include "tests/slocum.h"
#include "tests/world/fleet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace glider::tests {
namespace {

using ir::prove::EnergyBound;
using ir::prove::Rng;

const platforms::BoardPower& board() {
  static const auto usual = compiler::usualBoard(slocum());
  return *(*usual)->power;
}

/// A healthy vehicle in deep water: hookbeh does not have to turn it, which no bound counts.
simulator::Scenario drawSea(simulator::Scenario scenario, Rng& dice) {
  scenario.vehicle.initial_heading_rad = dice.within(0, 2 * std::numbers::pi);
  scenario.vehicle.flight.drag = dice.within(0.10, 0.20);
  drawWater(scenario.ocean, dice);
  scenario.ocean.bottom.depth_m = dice.within(80, 250);
  platforms::Power& power = scenario.vehicle.battery.power;
  const bool hungry = dice.chance(0.5);
  const auto factor = [&](double spread) { return 1 + spread * (hungry ? 1 : dice.within(-1, 1)); };
  for (platforms::Draw& draw : power.draws) {
    const double by = factor(draw.spread);
    draw.amount *= by;
    draw.amount_per_m *= by;
  }
  scenario.vehicle.battery.sbc_W = board().running_W * factor(board().spread);
  return scenario;
}

/// The energy that is taken while the SBC has control and hookbeh does what it says.
class EnergyWatch final : public simulator::FlightObserver {
 public:
  explicit EnergyWatch(const EnergyBound& bound) : bound_(bound) {}

  void said(std::span<const uint8_t>, double) override {}
  bool cycle(const simulator::CycleView& view) override {
    const bool active = view.hook == hooks::HookState::Active;
    if (!active) {
      return !began_;
    }
    const bool refused =
        view.array.get(GLIDER_X_HOOK_ANSWER) > static_cast<double>(hooks::HookAnswer::BadCheck);
    if (view.aborted || refused || view.overridden() ||
        (view.hookbeh != nullptr && view.hookbeh->guard != HookGuard::None)) {
      return false;  // what follows is not the mission's
    }
    if (!began_) {
      began_ = true;
      start_s_ = view.time_s;
      start_j_ = view.used_J;
    }
    seconds_ = view.time_s - start_s_;
    used_j_ = view.used_J - start_j_;
    const double most =
        std::min(bound_.joules.value_or(kEndless), bound_.start_j + bound_.watts * seconds_);
    nearest_ = std::max(nearest_, used_j_ / most);
    return true;
  }

  [[nodiscard]] double used() const { return used_j_; }
  [[nodiscard]] double seconds() const { return seconds_; }
  /// The greatest share of the bound at any time.
  [[nodiscard]] double nearest() const { return nearest_; }

 private:
  static constexpr double kEndless = 1e300;

  const EnergyBound& bound_;
  bool began_ = false;
  double start_s_ = 0, start_j_ = 0, seconds_ = 0, used_j_ = 0, nearest_ = 0;
};

struct Flown {
  double nearest = 0, used_j = 0, seconds = 0;
};

Flown fly(const FlyingMission& mission, const EnergyBound& bound,
          const simulator::Scenario& scenario, uint64_t seed) {
  EnergyWatch watch(bound);
  simulator::SimulationSetup setup;
  setup.platform = slocum();
  setup.scenario = scenario;
  setup.seed = seed;
  setup.observer = &watch;
  for (const ir::Sensor& sensor : mission.flown->mission.sensors) {
    setup.read.push_back(sensor.vehicle_name);
  }
  setup.sbc = std::make_unique<flights::InProcessSbc>(mission.loaded,
                                                      ir::defaultParameters(mission.flown->mission),
                                                      std::make_shared<flights::Card>(), false);
  const auto trace = simulator::simulate(std::move(setup));
  EXPECT_TRUE(trace) << mission.name;
  return {watch.nearest(), watch.used(), watch.seconds()};
}

/// A mission, its bound, and the flight that took the most.
struct Judged {
  FlyingMission mission;
  EnergyBound bound;
  Flown worst;
  double nearest = 0;
};

std::vector<Judged> judgedMissions(uint64_t random, uint64_t seed) {
  std::vector<Judged> all;
  for (FlyingMission& mission : missions(random, seed)) {
    const auto bound = ir::prove::energyBoundOf(mission.flown->checked->mission(), slocum(),
                                                board(), ir::prove::Parameters::AsWritten);
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
    const auto sea = drawSea(seas[i / judged.size() % seas.size()], dice);
    const Flown flown = fly(one.mission, one.bound, sea, i);
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
