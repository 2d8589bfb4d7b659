// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/judge_setup.h"

#include "hooks/hookbeh/hull.h"
#include "simulator/slocum/flight/behaviours/hookbeh_adapter.h"
#include "simulator/slocum/flight/mission_variables.h"
#include "simulator/slocum/own_mission.h"
#include "vehicles/slocum/oracles/depth_judge.h"
#include "vehicles/slocum/oracles/judge_limits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>

namespace glider::slocum::oracles {

namespace {

/// What hookbeh must make of b_args that the vehicle cannot carry out (hooks/hookbeh/README.md).
hooks::HookbehArgs withinHull(hooks::HookbehArgs args, const platforms::Envelope& hull) {
  constexpr double kLeastAltitude = 2, kLeastClimb = 0.5;
  args.greatest_depth_m = std::min(args.greatest_depth_m, hull.greatest_depth_m);
  args.steepest_pitch_rad =
      std::clamp(args.steepest_pitch_rad, hull.shallowest_pitch_rad, hull.steepest_pitch_rad);
  args.shallowest_pitch_rad =
      std::clamp(args.shallowest_pitch_rad, hull.shallowest_pitch_rad, hull.steepest_pitch_rad);
  args.greatest_fin_rad = std::clamp(args.greatest_fin_rad, 0.0, hull.fin_rad);
  args.greatest_pump_cc = std::clamp(args.greatest_pump_cc, 0.0, hull.pump_cc);
  args.greatest_battery_in = std::clamp(args.greatest_battery_in, 0.0, hull.battery_in);
  args.dive_pump_cc = -std::min(std::fabs(args.dive_pump_cc), hull.pump_cc);
  args.climb_pump_cc =
      std::clamp(std::fabs(args.climb_pump_cc), kLeastClimb * hull.pump_cc, hull.pump_cc);
  if (args.least_altitude_m >= 0) {
    args.least_altitude_m = std::max(args.least_altitude_m, kLeastAltitude);
  }
  args.silence_secs = std::min(args.silence_secs, hooks::kMostSilenceSecs);
  args.nap_secs = std::min(args.nap_secs, hooks::kMostNapSecs);
  return args;
}

/// How often the altimeter of the scenario's vehicle receives an echo, s; infinite for one that
/// detects the bottom too late. hookbeh has it read in each cycle.
double echoEvery(const Scenario& scenario, double cycle_s) {
  constexpr double kRange = 30;  // m: a dive at 26 degrees then has 130 s for an echo
  const AltimeterSettings& altimeter = scenario.sensors.altimeter;
  return altimeter.range_m >= kRange && altimeter.dropout < 1 ? cycle_s / (1 - altimeter.dropout)
                                                              : kForever;
}

/// Without those of faults of sensors.
std::vector<FaultKind> othersOf(const std::vector<FaultKind>& kinds) {
  std::vector<FaultKind> others;
  std::ranges::copy_if(kinds, std::back_inserter(others),
                       [](FaultKind kind) { return !isOfSensors(kind); });
  return others;
}

/// How many different sensors are wrong.
size_t wrongSensors(const Faults& faults) {
  std::set<std::string> names;
  for (const SensorFault& fault : faults.sensors) {
    names.insert(fault.name);
  }
  return names.size();
}

/// Scenarios may name sensors by either name: the checks use the vehicle's.
void nameSensors(const platforms::Platform& platform, Faults& faults) {
  for (SensorFault& fault : faults.sensors) {
    const platforms::PlatformSensor* sensor = platform.find(fault.name);
    fault.name = sensor == nullptr ? fault.name : sensor->name;
  }
}

}  // namespace

Promise JudgeSetup::promiseAt(double now_s) const {
  constexpr double kSettles = 1800;  // s: three times the longest wait of a guard
  if (!whole || faults.sensors.empty()) {
    return promise;
  }
  double from_s = kForever, to_s = 0;
  for (const SensorFault& fault : faults.sensors) {
    from_s = std::min(from_s, fault.when.from_s);
    to_s = std::max(to_s, fault.when.to_s);
  }
  if (now_s < from_s) {
    return *whole;
  }
  Promise now = promise;
  if (now_s > to_s + kSettles) {
    now.deepest = whole->deepest;
    now.clearance = whole->clearance;
  }
  return now;
}

/// The loads of a way up, and what the pump takes.
void addPower(const simulator::BatterySettings& battery, JudgeSetup& setup) {
  setup.loads_W = battery.sbc_W.value_or(0);
  for (const platforms::Draw& draw : battery.power.draws) {
    if (draw.when == platforms::DrawWhen::Always || draw.when == platforms::DrawWhen::Read) {
      setup.loads_W += draw.amount;
    }
    if (draw.when == platforms::DrawWhen::PumpOut) {
      setup.pump_out_j_cc = draw.amount;
      setup.pump_out_j_cc_m = draw.amount_per_m;
    }
  }
}

JudgeSetup judgeSetup(const platforms::Platform& platform, const Scenario& scenario,
                      const std::vector<FaultKind>& kinds) {
  JudgeSetup setup;
  setup.faults = scenario.faults;
  nameSensors(platform, setup.faults);
  setup.promise = promiseOf(kinds);
  if (wrongSensors(setup.faults) == 1) {  // drawn twice, it is still one
    setup.promise.deepest = std::min(setup.promise.deepest, Deepest::TenMetres);
  }
  setup.whole = promiseOf(othersOf(kinds));
  setup.has_ctd = scenario.sensors.ctd.dropout < 1;
  setup.hull_m = platform.envelope.greatest_depth_m;
  setup.pump_cc = platform.envelope.pump_cc;
  setup.dictionary = std::make_shared<const platforms::Dictionary>(platform);
  setup.cycle_s = platform.envelope.cycle_s;
  setup.line_lag_s = platform.world.line_lag_s;
  setup.turn_s = platform.world.turn_s;
  setup.slowest_climb_mps = platform.world.slowest_climb_m_s;
  setup.through_water_mps = platform.world.through_water_m_s;
  addPower(scenario.vehicle.battery, setup);
  const OceanSettings& ocean = scenario.ocean;
  setup.current_mps = std::max(std::hypot(ocean.current.east, ocean.current.north),
                               std::hypot(ocean.bottom_current.east, ocean.bottom_current.north));
  constexpr double kSpreads = 4;  // standard deviations
  setup.longest_cycle_s =
      std::max({setup.cycle_s, scenario.cycles.mean_s + kSpreads * scenario.cycles.spread_s,
                scenario.cycles.long_share > 0 ? scenario.cycles.long_s : 0});
  setup.echo_every_s = echoEvery(scenario, setup.cycle_s);
  for (const slocum::BehaviourBlock& behaviour : missionFileOf(scenario).behaviours) {
    if (behaviour.name == "hookbeh") {
      setup.has_hookbeh = true;
      setup.args = withinHull(hookbehArgs(behaviour), platform.envelope);
    } else if (behaviour.name == "abend") {
      setup.overdepth_m = behaviour.value("overdepth");
      setup.undervolts = behaviour.value("undervolts");
    } else if (behaviour.name == "yo") {
      setup.only_hookbeh = false;
    }
  }
  const double every_s =
      MissionVariables(missionFileOf(scenario)).find("c_pressure_time").value_or(setup.cycle_s);
  setup.late_m = std::max(0.0, every_s - setup.cycle_s) *
                 sinkRate(-setup.args.steepest_pitch_rad, -setup.pump_cc);
  return setup;
}

}  // namespace glider::slocum::oracles
