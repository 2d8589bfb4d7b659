// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/drawn.h"

namespace glider::simulator {
namespace {

/// Gives the b_arg `name` of a behaviour a value.
void put(slocum::BehaviourBlock& block, const char* name, double value) {
  for (slocum::Setting& setting : block.arguments) {
    if (setting.name == name) {
      setting.value = value;
      return;
    }
  }
  slocum::Setting setting;
  setting.name = name;
  setting.value = value;
  block.arguments.push_back(setting);
}

/// As a `sensor:` line or the behaviour sensors_in, whichever decides.
void setPressureTime(slocum::MissionFile& mission, double every_s) {
  constexpr const char* kName = "c_pressure_time";
  for (slocum::BehaviourBlock& block : mission.behaviours) {
    if (block.name == "sensors_in" && block.find(kName) != nullptr) {
      return put(block, kName, every_s);
    }
  }
  slocum::Setting setting;
  setting.name = kName;
  setting.value = every_s;
  mission.sensors.push_back(setting);
}

}  // namespace

void applyDrawn(const DrawnFaults& drawn, slocum::MissionFile& mission) {
  if (drawn.vehicle.pressure_every_s > 0) {
    setPressureTime(mission, drawn.vehicle.pressure_every_s);
  }
  if (!drawn.args) {
    return;
  }
  const DrawnArgs& args = *drawn.args;
  for (slocum::BehaviourBlock& behaviour : mission.behaviours) {
    if (behaviour.name == "hookbeh") {
      put(behaviour, "start_secs", args.start_secs);
      put(behaviour, "max_depth", args.max_depth_m);
      put(behaviour, "min_altitude", args.min_altitude_m);
      put(behaviour, "max_pitch", args.max_pitch_rad);
      put(behaviour, "hold_secs", args.hold_secs);
      put(behaviour, "d_bpump_value", args.dive_pump_cc);
      put(behaviour, "c_bpump_value", args.climb_pump_cc);
    }
  }
}

}  // namespace glider::simulator
