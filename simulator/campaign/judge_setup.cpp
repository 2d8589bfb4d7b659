// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/campaign/judge_setup.h"

#include "simulator/flight/behaviours/hookbeh_adapter.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {

namespace {

/// What hookbeh must make of b_args that the vehicle cannot carry out (hooks/hookbeh/README.md).
hooks::HookbehArgs withinHull(hooks::HookbehArgs args, const platforms::Envelope& hull) {
  constexpr double kLeastAltitude = 2, kMostSilence = 600, kLeastClimb = 0.5;
  args.greatest_depth_m = std::min(args.greatest_depth_m, hull.greatest_depth_m);
  args.steepest_pitch_rad =
      std::clamp(args.steepest_pitch_rad, hull.shallowest_pitch_rad, hull.steepest_pitch_rad);
  args.shallowest_pitch_rad =
      std::clamp(args.shallowest_pitch_rad, hull.shallowest_pitch_rad, hull.steepest_pitch_rad);
  args.dive_pump_cc = -std::min(std::fabs(args.dive_pump_cc), hull.pump_cc);
  args.climb_pump_cc =
      std::clamp(std::fabs(args.climb_pump_cc), kLeastClimb * hull.pump_cc, hull.pump_cc);
  if (args.least_altitude_m >= 0) {
    args.least_altitude_m = std::max(args.least_altitude_m, kLeastAltitude);
  }
  args.silence_secs = std::min(args.silence_secs, kMostSilence);
  return args;
}

}  // namespace

std::vector<FaultKind> kindsOf(const Faults& faults) {
  std::vector<FaultKind> kinds;
  const auto add = [&](bool there, FaultKind kind) {
    if (there) {
      kinds.push_back(kind);
    }
  };
  for (const LineFault& fault : faults.lines) {
    add(true, fault.cut || fault.heard_at_baud > 0 ? FaultKind::LineCut : FaultKind::ByteLoss);
  }
  for (const SensorFault& fault : faults.sensors) {
    const bool of_hook = fault.name.starts_with("sci_hook");
    add(true, of_hook ? FaultKind::HookSensor : FaultKind::SensorFrozen);
  }
  add(!faults.power.empty(), FaultKind::Power);
  add(!faults.port.empty(), FaultKind::Port);
  add(!faults.stuck.empty(), FaultKind::Stuck);
  add(!faults.science.empty(), FaultKind::Science);
  add(!faults.clock.empty(), FaultKind::Clock);
  add(!faults.card.empty(), FaultKind::Checkpoints);
  add(!faults.flight.empty(), FaultKind::FlightRestart);
  add(!faults.leftover.empty(), FaultKind::LeftOver);
  add(!faults.aborts.empty(), FaultKind::FlightAbort);
  return kinds;
}

double overtimeOf(const Scenario& scenario) {
  for (const slocum::BehaviourBlock& behaviour : scenario.skeleton.behaviours) {
    if (behaviour.name == "abend") {
      return std::max(0.0, behaviour.value("overtime"));
    }
  }
  return 0;
}

JudgeSetup judgeSetup(const platforms::Platform& platform, const Scenario& scenario,
                      const std::vector<FaultKind>& kinds) {
  JudgeSetup setup;
  setup.faults = scenario.faults;
  setup.promise = promiseOf(kinds);
  setup.has_ctd = scenario.sensors.ctd.dropout < 1;
  setup.hull_m = platform.envelope.greatest_depth_m;
  setup.pump_cc = platform.envelope.pump_cc;
  setup.dictionary = std::make_shared<const platforms::Dictionary>(platform);
  setup.cycle_s = platform.envelope.cycle_s;
  setup.turn_s = platform.world.turn_s;
  setup.slowest_climb_mps = platform.world.slowest_climb_m_s;
  for (const slocum::BehaviourBlock& behaviour : scenario.skeleton.behaviours) {
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
  return setup;
}

}  // namespace glider::simulator
