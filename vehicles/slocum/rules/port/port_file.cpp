// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/port/port_file.h"

#include "hooks/extctl/port.h"
#include "vehicles/slocum/port_files/port_plan.h"
#include "vehicles/slocum/rules/aborts.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace glider::slocum::rules {
namespace {

using hooks::extctl::PortSensor;

/// The number by which a program knows the mission file that was written with it.
constexpr const char* kProgramSensor = "u_mission_param_l";

bool isFrom(const BehaviourBlock& block, const char* argument, PortSensor parameter) {
  return missionParameter(block.value(argument)) == static_cast<int>(parameter);
}

/// Whether overdepth bounds the depth: a number that the vehicle can reach, and looks at.
bool isBound(const BehaviourBlock& abend, const platforms::Platform& platform) {
  const double overdepth = abend.value("overdepth");
  const double every = abend.value("overdepth_sample_time");
  return overdepth >= 0 &&
         overdepth <= platform.envelope.greatest_depth_m +
                          kAbortsBelow * platform.envelope.inflection_overshoot_m &&
         every >= 0 && every <= platform.world.tick_gap_s;
}

/// The `yo` between the two depths of the SBC.
bool isDriven(const BehaviourBlock& block) {
  return block.name == "yo" && isFrom(block, "d_target_depth", PortSensor::DiveDepth) &&
         isFrom(block, "c_target_depth", PortSensor::ClimbDepth);
}

}  // namespace

bool isPortFile(const MissionFile& file) {
  return std::ranges::any_of(file.behaviours, isDriven) &&
         std::ranges::find(file.sensors, kProgramSensor, &Setting::name) != file.sensors.end();
}

PortFile portFileOf(const MissionFile& file, const platforms::Platform& platform) {
  PortFile port;
  const auto abend = std::ranges::find(file.behaviours, "abend", &BehaviourBlock::name);
  port.deepest_m = std::numeric_limits<double>::infinity();
  if (abend != file.behaviours.end() && isBound(*abend, platform)) {
    // The hull's own limit is not kept by anything here.
    const double below_m = abend->value("overdepth") - platform.envelope.greatest_depth_m;
    port.deepest_m = abortsWithin(*abend, platform) + std::max(0.0, below_m);
  }
  port.layers = layersOf(file, platform);
  for (Layer& layer : port.layers) {
    if (isDriven(file.behaviours[layer.number - 1])) {
      layer.role = Role::Flies;
      layer.deepest_m = port.deepest_m;
      layer.legs.reset();
      layer.argument = "its depths are the SBC's";
      port.driven = layer.number;
    }
  }
  return port;
}

VehicleFile portVehicleFile(const MissionFile& file, const std::string& path,
                            const platforms::Platform& platform) {
  VehicleFile vehicle;
  vehicle.path = path;
  vehicle.name = std::filesystem::path(path).filename().string();
  vehicle.aborts = abortsOf(file);
  const platforms::Envelope& hull = platform.envelope;
  vehicle.commands.steepest_pitch_rad = hull.steepest_pitch_rad;
  vehicle.commands.shallowest_pitch_rad = hull.shallowest_pitch_rad;
  vehicle.commands.greatest_fin_rad = hull.fin_rad;
  // The port has neither: checkPortCommands() reports them.
  vehicle.commands.greatest_pump_cc = std::numeric_limits<double>::infinity();
  vehicle.commands.greatest_battery_in = std::numeric_limits<double>::infinity();
  if (vehicle.aborts.overdepth_m) {
    vehicle.commands.greatest_depth_m =
        *vehicle.aborts.overdepth_m - kAbortsBelow * hull.inflection_overshoot_m;
  }
  vehicle.refuser = "the program that was built with it";
  vehicle.limits_at = fmt::format("overdepth of abend in {}, which is {:.4g} m deeper",
                                  vehicle.name, kAbortsBelow * hull.inflection_overshoot_m);
  return vehicle;
}

void widenForPort(platforms::Platform& platform, double outage_s) {
  platform.world.command_delay_s +=  // that of naps, which the port refuses
      2 * hooks::extctl::kSettleSecs + platform.world.tick_gap_s + outage_s;
  platform.world.climb_hold_m = holdOf(platform);
  platform.world.depth_error_m += platform.envelope.vertical_rate_m_s * platform.world.line_lag_s;
}

}  // namespace glider::slocum::rules
