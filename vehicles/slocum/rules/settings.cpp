// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace glider::slocum::rules {
namespace {

/// Sensors without which the vehicle does not know its depth or its pitch, by the setting for how
/// often they are read.
constexpr std::array<std::string_view, 2> kNeeded = {"c_pressure_time", "c_att_time"};

/// Settings that change nothing on which the way to the surface rests, for any value.
constexpr auto kHarmless = std::to_array<std::string_view>({
    // unreadSensor() looks at their values.
    "c_pressure_time",
    "c_att_time",
    // The altimeter: it can only end a dive sooner, and no climb waits for it.
    "c_alt_time",
    "u_alt_reduced_usage_mode",
    // How often abend looks at them: an abort at any time is one of the endings.
    "u_battery_time",
    "u_vacuum_time",
    "c_leakdetect_time",
    // The GPS: only what is already at the surface, or climbs, waits for a fix.
    "c_gps_on",
    // Steering: no heading changes the depth.
    "u_use_current_correction",
    // Instruments.
    "c_science_all_on",
    "c_science_all_on_enabled",
    "c_profile_on",
    "c_flbbcd_on",
    "c_oxy4_on",
    "c_ctd41cp_num_fields_to_send",
    // What is written to the logs.
    "u_dbd_sensor_list_xmit_control",
    "u_sci_dbd_sensor_list_xmit_control",
    // Only the codes 15 and 11 of start_when read them, on which nothing relies.
    "u_mission_mode",
    "sci_wants_surface",
});

/// u_mission_param_a to z: what depends on a b_arg that reads one is refused.
bool isMissionParameter(std::string_view name) {
  constexpr std::string_view kPrefix = "u_mission_param_";
  return name.starts_with(kPrefix) && name.size() == kPrefix.size() + 1 && name.back() >= 'a' &&
         name.back() < 'a' + slocum::kMissionParameters;
}

/// Settings that are harmless with some values only: what value is needed; "" if it has it, and
/// none if the setting is not known.
std::optional<std::string> neededValue(const slocum::Setting& setting,
                                       const platforms::Platform& platform) {
  if (setting.name == "u_reqd_depth_at_surface") {  // down to it, the vehicle is "at the surface"
    const double most = platform.world.surface_depth_m;
    return setting.value <= most ? "" : fmt::format("a value of at most {:g}", most);
  }
  if (setting.name == "u_cycle_time") {  // of which tick_gap_s is a multiple
    const double usual = platform.envelope.cycle_s;
    return setting.value == usual ? "" : fmt::format("the value {:g}", usual);
  }
  return std::nullopt;
}

bool isHarmless(const slocum::Setting& setting, const platforms::Platform& platform) {
  return std::ranges::find(kHarmless, setting.name) != kHarmless.end() ||
         isMissionParameter(setting.name) || neededValue(setting, platform) == "";
}

/// The settings in force that are not known to be harmless. Those of the mission stand above the
/// vehicle's own; f_… there is its calibration, which a healthy vehicle has right.
std::vector<const slocum::Setting*> doubtful(const slocum::MissionFile& vehicle,
                                             const platforms::Platform& platform) {
  std::vector<const slocum::Setting*> all;
  for (const slocum::Setting& setting : vehicle.sensors) {
    if (!isHarmless(setting, platform)) {
      all.push_back(&setting);
    }
  }
  for (const slocum::Setting& setting : vehicle.vehicle_sensors) {
    const bool replaced = std::ranges::find(vehicle.sensors, setting.name,
                                            &slocum::Setting::name) != vehicle.sensors.end();
    if (!replaced && !setting.name.starts_with("f_") && !isHarmless(setting, platform)) {
      all.push_back(&setting);
    }
  }
  return all;
}

std::string textOf(const slocum::Setting& setting) {
  return fmt::format("{} {:.7g}", setting.name, setting.value);
}

}  // namespace

SettingInForce settingInForce(const slocum::MissionFile& vehicle, std::string_view name) {
  for (const slocum::BehaviourBlock& block : vehicle.behaviours) {
    // As in the simulator, a time that sensors_in does not give stays as it was.
    const slocum::Setting* given = block.name == "sensors_in" ? block.find(name) : nullptr;
    if (given != nullptr && !block.lacks_file) {
      return {given->value, given->name_range};
    }
  }
  for (const auto* settings : {&vehicle.sensors, &vehicle.vehicle_sensors}) {
    const auto found = std::ranges::find(*settings, name, &slocum::Setting::name);
    if (found != settings->end()) {
      return {found->value, found->name_range};
    }
  }
  return {};
}

std::optional<Doubt> doubtfulSetting(const slocum::MissionFile& vehicle,
                                     const platforms::Platform& platform) {
  const auto all = doubtful(vehicle, platform);
  if (all.empty()) {
    return std::nullopt;
  }
  const slocum::Setting& first = *all.front();
  std::vector<std::string> others;
  for (const slocum::Setting* setting : all) {
    if (setting != &first) {
      others.push_back(textOf(*setting));
    }
  }
  const auto needed = neededValue(first, platform);
  return Doubt{fmt::format("what the setting {} does to the way to the surface is not known{}{}",
                           textOf(first),
                           others.empty() ? "" : "; nor what these do: ", fmt::join(others, ", ")),
               "delete its line `sensor:`" + (needed ? ", or give it " + *needed : std::string()),
               first.name_range};
}

std::optional<Doubt> unreadSensor(const slocum::MissionFile& vehicle,
                                  const platforms::Platform& platform) {
  for (const std::string_view name : kNeeded) {
    const SettingInForce setting = settingInForce(vehicle, name);
    if (!(setting.value >= 0 && setting.value <= platform.world.tick_gap_s)) {
      return Doubt{fmt::format("the vehicle seldom or never reads a sensor that it needs ({} {:g})",
                               name, setting.value),
                   fmt::format("give `{}` the value 0: in every cycle", name), setting.range};
    }
  }
  return std::nullopt;
}

Doubt changesInFlight(const slocum::BehaviourBlock& block, const std::string& label,
                      std::string_view argument) {
  return {fmt::format("{} has {} {:.7g}, a mission parameter, which may change in flight", label,
                      argument, block.value(argument)),
          fmt::format("give `{}` a number that does not change in flight", argument), block.range};
}

}  // namespace glider::slocum::rules
