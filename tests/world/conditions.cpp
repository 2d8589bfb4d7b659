// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/world/conditions.h"

#include "ir/eval/interpreter.h"
#include "ir/prove/falsification/rng.h"
#include "simulator/slocum/own_mission.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace glider::tests {
namespace {

using ir::prove::Rng;
using simulator::FaultKind;

constexpr double kLongest = 10800;  // s
constexpr std::array<const char*, 9> kNeeded = {
    "m_depth",        "m_pitch",        "m_present_secs_into_mission",
    "m_pressure",     "m_depth_rate",   "m_altitude",
    "m_cycle_number", "m_present_time", "sci_water_pressure"};

/// Water and vehicle as they may be on another day.
void change(simulator::Scenario& scenario, Rng& dice) {
  scenario.latitude_deg += dice.within(-0.02, 0.02);
  scenario.longitude_deg += dice.within(-0.02, 0.02);
  scenario.vehicle.initial_heading_rad = dice.within(0, 2 * std::numbers::pi);
  scenario.vehicle.flight.drag = dice.within(0.10, 0.20);
  scenario.vehicle.flight.mass_kg += dice.within(-0.05, 0.05);  // badly trimmed
  drawWater(scenario.ocean, dice);
  scenario.ocean.bottom.depth_m = dice.within(20, 100);
}

std::vector<double> drawParameters(const ir::Mission& mission, Rng& dice) {
  constexpr int kTries = 30;
  constexpr double kFar = 1e6;
  for (int i = 0; i < kTries; ++i) {
    std::vector<double> values = ir::defaultParameters(mission);
    size_t number = 0;
    for (const ir::Variable& variable : mission.variables) {
      if (variable.kind != ir::VariableKind::Parameter) {
        continue;
      }
      double& value = values[number++];
      const bool truth = variable.type.kind == ir::TypeKind::Bool;
      const double lowest = std::max(variable.lowest, -kFar);
      const double highest = std::min(variable.highest, kFar);
      value = truth ? dice.below(2) : dice.chance(0.5) ? dice.within(lowest, highest) : value;
    }
    if (!ir::failedCondition(mission, values)) {
      return values;
    }
  }
  return ir::defaultParameters(mission);
}

/// Whether what goes wrong leaves the SBC and its port alone.
bool leavesProgram(const simulator::Faults& faults) {
  return faults.power.empty() && faults.port.empty() && faults.stuck.empty() &&
         faults.flight.empty();
}

}  // namespace

void drawWater(simulator::OceanSettings& ocean, Rng& dice) {
  ocean.current = {dice.within(-0.35, 0.35), dice.within(-0.35, 0.35)};
  ocean.bottom_current = {dice.within(-0.35, 0.35), dice.within(-0.35, 0.35)};
  ocean.wave = {dice.within(0, 5), dice.within(600, 2400),
                dice.chance(0.5) ? 0 : dice.within(300, 2000), dice.within(0, 6)};
  ocean.thermocline_depth_m = dice.within(8, 25);
}

Conditions drawConditions(const ir::Mission& mission, const simulator::Scenario& scenario,
                          uint64_t seed) {
  Rng dice(seed);
  Conditions drawn;
  drawn.scenario = scenario;
  drawn.seed = seed;
  if (dice.chance(0.5)) {
    change(drawn.scenario, dice);
  }
  drawn.scenario.duration_s = std::min(drawn.scenario.duration_s, kLongest);
  drawn.parameters = drawParameters(mission, dice);
  if (dice.chance(0.5)) {
    drawn.kind = static_cast<FaultKind>(dice.below(simulator::kFaultKinds));
    const simulator::FlightTimes times{drawn.scenario.duration_s, 0, drawn.scenario.duration_s};
    const auto manner = static_cast<simulator::Manner>(dice.below(simulator::kManners));
    simulator::Faults faults = simulator::drawFaults(drawn.kind, manner, seed, times).faults;
    std::erase_if(faults.sensors, [](const simulator::SensorFault& fault) {
      return std::ranges::find(kNeeded, fault.name) != kNeeded.end() ||
             fault.name.starts_with("x_hook") || fault.name.starts_with("sci_hook");
    });
    drawn.scenario.faults.add(faults);
  }
  const simulator::Faults& faults = drawn.scenario.faults;
  drawn.program_runs = leavesProgram(faults);
  drawn.whole = drawn.program_runs && faults.lines.empty() && faults.science.empty() &&
                faults.console.empty();
  const auto& behaviours = simulator::missionFileOf(drawn.scenario).behaviours;
  drawn.from_surface = std::ranges::none_of(
      behaviours, [](const auto& behaviour) { return behaviour.name == "yo"; });
  return drawn;
}

}  // namespace glider::tests
