// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/energy/watched_energy.h"

#include "compiler/boards.h"
#include "flights/in_process_sbc.h"
#include "hooks/hookbeh/hookbeh.h"
#include "hooks/protocol/values.h"
#include "ir/eval/interpreter.h"
#include "ir/worlds/naps.h"
#include "platforms/load/power.h"
#include "simulator/scenario/scenario.h"
#include "simulator/simulator.h"
#include "tests/slocum.h"
#include "tests/world/fleet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>
#include <utility>

namespace glider::tests {
namespace {

using ir::prove::EnergyBound;

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
    flown_.seconds = view.time_s - start_s_;
    flown_.used_j = view.used_J - start_j_;
    const double most =
        std::min(bound_.joules.value_or(kEndless), bound_.start_j + bound_.watts * flown_.seconds);
    flown_.nearest = std::max(flown_.nearest, flown_.used_j / most);
    return true;
  }

  [[nodiscard]] const FlownEnergy& flown() const { return flown_; }

 private:
  static constexpr double kEndless = 1e300;

  const EnergyBound& bound_;
  FlownEnergy flown_;
  bool began_ = false;
  double start_s_ = 0, start_j_ = 0;
};

/// An internal wave somewhere in the depths of the mission, with which its yos may keep step.
void setWave(simulator::OceanSettings& ocean, double deepest_m, ir::prove::Rng& dice) {
  const double period_s = dice.within(240, 2400);
  const double moves_m_s = dice.within(0, platforms::kWaterMoves_m_s);
  ocean.wave.period_s = period_s;
  ocean.wave.amplitude_m = moves_m_s * period_s / (2 * std::numbers::pi);
  ocean.thermocline_depth_m = dice.within(8, std::max(25.0, deepest_m));
}

}  // namespace

const platforms::BoardPower& usualBoardPower() {
  static const auto usual = compiler::usualBoard(slocum());
  return *(*usual)->power;
}

std::optional<EnergyBound> boundOfEnergy(const FlyingMission& mission,
                                         const platforms::Platform& platform,
                                         const platforms::BoardPower& board) {
  platforms::Platform vehicle = platform;
  ir::allowForNaps(mission.flown->mission, vehicle.world);
  return ir::prove::energyBoundOf(mission.flown->checked->mission(), vehicle, board,
                                  ir::prove::Parameters::AsWritten);
}

void setHunger(simulator::VehicleSettings& vehicle, const platforms::BoardPower& board,
               const std::function<double()>& share) {
  for (platforms::Draw& draw : vehicle.battery.power.draws) {
    const double by = 1 + draw.spread * share();
    draw.amount *= by;
    draw.amount_per_m *= by;
  }
  vehicle.battery.sbc_W = board.running_W * (1 + board.spread * share());
}

FlownEnergy flyForEnergy(const FlyingMission& mission, const EnergyBound& bound,
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
  return watch.flown();
}

simulator::Scenario deepSea() {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto path = std::filesystem::path(GLIDER_SOURCE_DIR) / "tests/energy/still.toml";
  simulator::Scenario sea = *simulator::loadScenario(path, slocum(), sources, diagnostics);
  constexpr double kDay_s = 86400;
  sea.duration_s = kDay_s;
  return sea;
}

simulator::Scenario drawSea(simulator::Scenario scenario, const EnergyBound& bound,
                            ir::prove::Rng& dice) {
  scenario.vehicle.initial_heading_rad = dice.within(0, 2 * std::numbers::pi);
  scenario.vehicle.flight.drag = dice.within(0.10, 0.20);
  drawWater(scenario.ocean, dice);
  setWave(scenario.ocean, bound.deepest_m, dice);
  const double shallowest = bound.deepest_m + platforms::kBelowDives_m;
  scenario.ocean.bottom.depth_m =
      dice.chance(0.5) ? shallowest : std::max(shallowest, dice.within(80, 250));
  if (dice.chance(0.5)) {
    scenario.ocean.swell = {.amplitude_m = dice.within(0, platforms::kSwell_m),
                            .period_s = dice.within(6, platforms::kSwell_s),
                            .bearing_rad = dice.within(0, 2 * std::numbers::pi),
                            .followed_share = dice.within(0, 1)};
  }
  const bool hungry = dice.chance(0.5);
  setHunger(scenario.vehicle, usualBoardPower(), [&] { return hungry ? 1 : dice.within(-1, 1); });
  return scenario;
}

}  // namespace glider::tests
