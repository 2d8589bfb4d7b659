// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/flight/skeleton.h"

#include "simulator/flight/device.h"
#include "simulator/flight/science_switches.h"
#include "simulator/sensors/sensor_list.h"
#include "slocum/mission_files/behaviour_catalogue.h"
#include "slocum/mission_files/load.h"
#include "support/diagnostics/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace glider::simulator {

using support::DiagnosticEngine;
using support::DiagnosticId;

namespace {

constexpr std::string_view kPrimaryDistance = "m_dist_to_primary_wpt";

/// Sensors whose settings this simulator reads.
bool isRead(std::string_view sensor) {
  return sensor.starts_with("u_mission_param_") || sensor == "u_mission_mode" ||
         sensor == "sci_wants_surface" || sensor == "u_use_current_correction" ||
         sensor == kPrimaryDistance || isDeviceSetting(sensor) || isScienceSwitch(sensor);
}

/// The codes that this simulator models for an enumerated b_arg.
struct Codes {
  std::string_view behaviour, argument;
  std::vector<int> codes;
};
const std::vector<int> kStart = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18};
const std::vector<int> kStop = {1, 2, 3, 4, 5, 7, 8, 9, 15, 17, 18};
const std::vector<int> kFlag = {0, 1};
const std::vector<int> kPump = {0, 2};
const std::vector<int> kUnits = {0, 1, 2};
const std::vector<int> kPitch = {1, 2, 3};
const std::vector<int> kEnd = {0, 2};
const auto kCodes = std::to_array<Codes>({
    {"surface", "start_when", kStart},
    {"surface", "end_action", {0, 1, 2, 3, 4, 5}},
    {"surface", "c_use_bpump", {0, 2, 3}},
    {"surface", "c_use_pitch", kPitch},
    {"yo", "start_when", kStart},
    {"yo", "end_action", kEnd},
    {"yo", "stop_when", kStop},
    {"yo", "start_diving", kFlag},
    {"yo", "d_use_bpump", kPump},
    {"yo", "c_use_bpump", kPump},
    {"yo", "d_use_pitch", kPitch},
    {"yo", "c_use_pitch", kPitch},
    {"set_heading", "start_when", kStart},
    {"set_heading", "stop_when", kStop},
    {"set_heading", "end_action", kEnd},
    {"set_heading", "use_heading", {1, 4}},
    {"goto_wpt", "start_when", kStart},
    {"goto_wpt", "stop_when", kStop},
    {"goto_wpt", "end_action", kEnd},
    {"goto_wpt", "wpt_units", kUnits},
    {"goto_list", "start_when", kStart},
    {"goto_list", "list_stop_when", kStop},
    {"goto_list", "end_action", {0, 2, 6}},
    {"dive_to", "start_when", kStart},
    {"dive_to", "use_bpump", kPump},
    {"dive_to", "use_pitch", kPitch},
    {"dive_to", "end_action", kEnd},
    {"climb_to", "start_when", kStart},
    {"climb_to", "use_bpump", kPump},
    {"climb_to", "use_pitch", kPitch},
    {"climb_to", "end_action", kEnd},
    {"prepare_to_dive", "start_when", {0, 1, 2, 3, 4, 5, 8, 11, 14}},  // it has no other b_args
    {"drift_at_depth", "start_when", kStart},
    {"drift_at_depth", "end_action", kEnd},
    {"drift_at_depth", "use_pitch", kPitch},
    {"drift_at_depth", "d_use_bpump", kPump},
    {"drift_at_depth", "c_use_bpump", kPump},
    {"drift_at_depth", "d_use_pitch", kPitch},
    {"drift_at_depth", "c_use_pitch", kPitch},
    {"hookbeh", "d_use_bpump", kPump},
    {"hookbeh", "c_use_bpump", kPump},
});

/// Bounds of a number.
struct Bounds {
  std::string_view behaviour, argument;
  double lowest, highest;
};
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kSteep = 1.2;  // rad
constexpr auto kBounds = std::to_array<Bounds>({
    {"yo", "num_half_cycles_to_do", -1, 999999},
    {"yo", "d_target_depth", 0, 2000},
    {"yo", "c_target_depth", 0, 2000},
    {"yo", "d_pitch_value", -kSteep, kSteep},
    {"yo", "c_pitch_value", -kSteep, kSteep},
    {"surface", "c_pitch_value", -kSteep, kSteep},
    {"surface", "gps_wait_time", 0, kNoLimit},
    {"surface", "keystroke_wait_time", 0, kNoLimit},
    {"sample", "state_to_sample", 0, 15},
    {"hookbeh", "start_secs", 0, kNoLimit},
    {"hookbeh", "max_depth", 1, 2000},
    {"hookbeh", "max_pitch", 0.1, kSteep},
    {"hookbeh", "min_pitch", 0, kSteep},
    {"hookbeh", "silence_secs", 8, 3600},
    {"hookbeh", "hold_secs", 0, 3600},
    {"hookbeh", "d_bpump_value", -1000, 0},
    {"hookbeh", "c_bpump_value", 0, 1000},
});

std::string listOf(const std::vector<int>& codes) {
  std::string out = "it must be one of ";
  const char* separator = "";
  for (const int code : codes) {
    out += separator + std::to_string(code);
    separator = ", ";
  }
  return out;
}

/// The behaviours that this simulator flies.
std::string flown() {
  std::string out;
  for (const auto& known : slocum::knownBehaviours()) {
    out += (out.empty() ? "`" : ", `") + std::string(known.name) + "`";
  }
  return out;
}

void refuse(const slocum::BehaviourBlock& block, const slocum::Setting& given,
            const std::string& why, DiagnosticEngine& diagnostics) {
  diagnostics.report(DiagnosticId::argumentValue, given.value_range, given.name, given.value, why)
      .note(block.range, "in this behaviour");
}

void checkValues(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  for (const slocum::Setting& given : block.arguments) {
    for (const Codes& row : kCodes) {
      const auto isValue = [&](int code) { return given.value == code; };
      if (row.behaviour == block.name && row.argument == given.name &&
          std::ranges::none_of(row.codes, isValue)) {
        refuse(block, given, listOf(row.codes), diagnostics);
      }
    }
    for (const Bounds& row : kBounds) {
      const bool within = given.value >= row.lowest && given.value <= row.highest;
      const bool number = !slocum::missionParameter(given.value);
      if (row.behaviour == block.name && row.argument == given.name && number && !within) {
        refuse(block, given, fmt::format("it must be between {} and {}", row.lowest, row.highest),
               diagnostics);
      }
    }
  }
}

/// Positions in latitude and longitude must be on Earth: one that was never set is not.
void checkPlace(const slocum::BehaviourBlock& block, const std::string& suffix,
                DiagnosticEngine& diagnostics) {
  constexpr double kLatLon = 2;
  if (block.value("wpt_units" + suffix) != kLatLon) {
    return;
  }
  const auto check = [&](const std::string& name, double most) {
    const slocum::Setting* given = block.find(name);
    if (given != nullptr && !slocum::missionParameter(given->value) &&
        !(std::fabs(given->value) <= most)) {
      refuse(block, *given,
             given->value == slocum::kUnsetPosition
                 ? "it is the vehicle's value for a position that was never set"
                 : fmt::format("it must be between {} and {}", -most, most),
             diagnostics);
    }
  };
  check("wpt_x" + suffix, 18000);
  check("wpt_y" + suffix, 9000);
}

void checkList(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  constexpr int kMostInArguments = 8;
  const double stated = block.value("num_waypoints");
  const slocum::Setting* given = block.find("num_waypoints");
  const double most =
      block.waypoints.empty() ? kMostInArguments : static_cast<double>(block.waypoints.size());
  if (!(stated >= 1 && stated <= most)) {
    diagnostics
        .report(DiagnosticId::argumentValue, given != nullptr ? given->value_range : block.range,
                "num_waypoints", stated,
                fmt::format("it must be between 1 and {}, the number of waypoints", most))
        .note(block.range, "in this behaviour");
  }
  if (block.value("num_legs_to_run") == 0 || block.value("num_legs_to_run") < -2) {
    refuse(block, *block.find("num_legs_to_run"), "it must be -2, -1 or at least 1", diagnostics);
  }
  for (int i = 0; i < kMostInArguments && i < stated && block.waypoints.empty(); ++i) {
    checkPlace(block, "_" + std::to_string(i), diagnostics);
  }
}

/// What this simulator does not have is named once for each behaviour.
void warnOfThruster(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  for (const slocum::Setting& given : block.arguments) {
    if (given.name.ends_with("use_thruster") && given.value != 0) {
      diagnostics.report(DiagnosticId::argumentWithoutEffect, given.name_range, given.name,
                         block.name, "the simulated vehicle has no thruster");
      return;
    }
  }
}

/// A negative value switches off what is not there anyway.
bool switchesOn(const slocum::Setting& given) {
  return given.value >= 0;
}

/// Of what sensors_in and sample switch on, what this simulator does not have.
void warnOfInstruments(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  const auto warn = [&](const slocum::Setting& given, const char* why) {
    diagnostics.report(DiagnosticId::argumentWithoutEffect, given.name_range, given.name,
                       block.name, why);
  };
  for (const slocum::Setting& given : block.arguments) {
    const bool proglet = given.name.starts_with("c_") && given.name.ends_with("_on");
    const bool known = isDeviceSetting(given.name) || isScienceSwitch(given.name);
    if (block.name == "sensors_in" && proglet && !known && switchesOn(given)) {
      warn(given, "the simulated science computer has no such instrument");
    }
  }
  const slocum::Setting* type = block.name == "sample" ? block.find("sensor_type") : nullptr;
  const auto is_type = [&](const Proglet& proglet) { return proglet.sensor_type == type->value; };
  if (type != nullptr && type->value != 0 && block.value("intersample_time") >= 0 &&
      std::ranges::none_of(simulatedProglets(), is_type)) {
    warn(*type, "the simulated science computer has no such instrument");
  }
}

/// Which waypoint is the primary one, the vehicle's public documents do not say.
void warnOfPrimaryWaypoint(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  for (const slocum::Setting& given : block.arguments) {
    if (given.name.ends_with("_when") && (given.value == 17 || given.value == 18)) {
      diagnostics.report(DiagnosticId::argumentWithoutEffect, given.name_range, given.name,
                         block.name,
                         "the simulated vehicle has no primary waypoint: set "
                         "`m_dist_to_primary_wpt` in the mission or in [[operator.put]]");
    }
  }
}

/// An autoexec.mi may have hundreds of settings: one warning names those that have no effect.
void warnOfVehicleSettings(const std::vector<slocum::Setting>& settings,
                           DiagnosticEngine& diagnostics) {
  constexpr size_t kMostNamed = 12;
  std::vector<const slocum::Setting*> unread;
  for (const slocum::Setting& setting : settings) {
    if (!isRead(setting.name)) {
      unread.push_back(&setting);
    }
  }
  if (unread.empty()) {
    return;
  }
  const slocum::Setting& first = *unread.front();
  auto warning =
      diagnostics.report(DiagnosticId::sensorWithoutEffect, first.name_range, first.name);
  std::string others;
  for (size_t i = 1; i < std::min(unread.size(), kMostNamed); ++i) {
    others += fmt::format("{}`{}`", i == 1 ? "" : ", ", unread[i]->name);
  }
  if (unread.size() > kMostNamed) {
    others += fmt::format(" and {} more", unread.size() - kMostNamed);
  }
  if (!others.empty()) {
    warning.note(first.name_range, fmt::format("nor have, of this file: {}", others));
  }
}

void checkBehaviour(const slocum::BehaviourBlock& block, bool has_primary,
                    DiagnosticEngine& diagnostics) {
  if (slocum::findBehaviour(block.name) == nullptr) {
    if (slocum::isNearlyABehaviour(block.name)) {
      diagnostics.report(DiagnosticId::unknownBehaviour, block.range, block.name, flown());
    } else {
      diagnostics.report(DiagnosticId::behaviourWithoutEffect, block.range, block.name,
                         "the simulator does not know it");
    }
    return;
  }
  slocum::checkArguments(block, diagnostics);
  checkValues(block, diagnostics);
  warnOfThruster(block, diagnostics);
  warnOfInstruments(block, diagnostics);
  if (!has_primary) {
    warnOfPrimaryWaypoint(block, diagnostics);
  }
  if (block.name == "goto_list") {
    checkList(block, diagnostics);
  } else if (block.name == "goto_wpt") {
    checkPlace(block, "", diagnostics);
  }
}

}  // namespace

void checkSkeleton(const slocum::MissionFile& mission, support::SourceRange place,
                   DiagnosticEngine& diagnostics) {
  if (mission.behaviours.empty()) {
    diagnostics.report(DiagnosticId::noBehaviours, place);
  }
  for (const slocum::Setting& sensor : mission.sensors) {
    if (!isRead(sensor.name)) {
      diagnostics.report(DiagnosticId::sensorWithoutEffect, sensor.name_range, sensor.name);
    }
  }
  warnOfVehicleSettings(mission.vehicle_sensors, diagnostics);
  const auto is_primary = [](const slocum::Setting& setting) {
    return setting.name == kPrimaryDistance;
  };
  const bool has_primary = std::ranges::any_of(mission.sensors, is_primary) ||
                           std::ranges::any_of(mission.vehicle_sensors, is_primary);
  const slocum::BehaviourBlock* hookbeh = nullptr;
  std::set<std::string_view> without_effect;  // each is named once
  for (const slocum::BehaviourBlock& block : mission.behaviours) {
    if (slocum::findBehaviour(block.name) == nullptr && !without_effect.insert(block.name).second) {
      continue;
    }
    if (!block.lacks_file) {
      checkBehaviour(block, has_primary, diagnostics);
    }
    if (block.name == "hookbeh" && hookbeh != nullptr) {
      diagnostics.report(DiagnosticId::duplicateArgument, block.range, block.name)
          .note(hookbeh->range, "the first is here");
    }
    hookbeh = block.name == "hookbeh" ? &block : hookbeh;
  }
}

support::Result<slocum::MissionFile> loadMissionFile(const std::filesystem::path& path,
                                                     support::SourceManager& sources,
                                                     DiagnosticEngine& diagnostics) {
  return slocum::loadMission(path, sources, diagnostics, checkSkeleton);
}

}  // namespace glider::simulator
