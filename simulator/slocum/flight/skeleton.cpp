// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/skeleton.h"

#include "simulator/sensors/sensor_list.h"
#include "simulator/slocum/flight/argument_values.h"
#include "simulator/slocum/flight/device.h"
#include "simulator/slocum/flight/science_switches.h"
#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/slocum/mission_files/behaviour_catalogue.h"
#include "vehicles/slocum/mission_files/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace glider::simulator {

using support::DiagnosticEngine;

namespace {

constexpr std::string_view kPrimaryDistance = "m_dist_to_primary_wpt";
constexpr int kMostInArguments = 8;  // waypoints of a goto_list without an argument file

/// Sensors whose settings this simulator reads.
bool isRead(std::string_view sensor) {
  return sensor.starts_with("u_mission_param_") || sensor == "u_mission_mode" ||
         sensor == "sci_wants_surface" || sensor == "u_use_current_correction" ||
         sensor == kPrimaryDistance || sensor == kWorkingDepth || isDeviceSetting(sensor) ||
         isScienceSwitch(sensor);
}

/// Whether this simulator flies, or reads, a behaviour of the catalogue.
bool hasEffect(std::string_view behaviour) {
  constexpr std::string_view kNone[] = {"compass_cal", "comatose", "bconsci", "badd_b"};
  return std::ranges::find(kNone, behaviour) == std::end(kNone);
}

/// The behaviours that this simulator flies.
std::string flown() {
  std::string out;
  for (const auto& known : slocum::knownBehaviours()) {
    if (hasEffect(known.name)) {
      out += (out.empty() ? "`" : ", `") + std::string(known.name) + "`";
    }
  }
  return out;
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
      refuseValue(block, *given,
                  given->value == slocum::kUnsetPosition
                      ? "it is the vehicle's value for a position that was never set"
                      : fmt::format("it must be between {} and {}", -most, most),
                  diagnostics);
    }
  };
  check("wpt_x" + suffix, 18000);
  check("wpt_y" + suffix, 9000);
}

/// Whether the number of waypoints is right. In an argument file it only repeats the list's length.
void checkLength(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  const double stated = block.value("num_waypoints");
  const slocum::Setting* given = block.find("num_waypoints");
  const size_t listed = block.waypoints.size();
  if (listed > 0) {
    if (given != nullptr && stated != static_cast<double>(listed)) {
      diagnostics
          .report(support::diagnostics::listLength, given->value_range, stated,
                  fmt::format("{} waypoint{}", listed, listed == 1 ? "" : "s"))
          .note(block.range, "in this behaviour");
    }
  } else if (!(stated >= 1 && stated <= kMostInArguments)) {
    diagnostics
        .report(
            support::diagnostics::argumentValue,
            given != nullptr ? given->value_range : block.range, "num_waypoints", stated,
            fmt::format("it must be between 1 and {}, the number of waypoints", kMostInArguments))
        .note(block.range, "in this behaviour");
  }
}

void checkList(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  checkLength(block, diagnostics);
  const double stated = block.value("num_waypoints");
  if (block.value("num_legs_to_run") == 0 || block.value("num_legs_to_run") < -2) {
    refuseValue(block, *block.find("num_legs_to_run"), "it must be -2, -1 or at least 1",
                diagnostics);
  }
  for (int i = 0; i < kMostInArguments && i < stated && block.waypoints.empty(); ++i) {
    checkPlace(block, "_" + std::to_string(i), diagnostics);
  }
}

/// A negative value switches off what is not there anyway.
bool switchesOn(const slocum::Setting& given) {
  return given.value >= 0;
}

/// Of what sensors_in and sample switch on, what this simulator does not have.
void warnOfInstruments(const slocum::BehaviourBlock& block, DiagnosticEngine& diagnostics) {
  const auto warn = [&](const slocum::Setting& given, const char* why) {
    diagnostics.report(support::diagnostics::argumentWithoutEffect, given.name_range, given.name,
                       block.name, why);
  };
  for (const slocum::Setting& given : block.arguments) {
    const bool proglet = given.name.starts_with("c_") && given.name.ends_with("_on");
    const bool known = isDeviceSetting(given.name) || isScienceSwitch(given.name);
    const bool port = given.name == "c_extctl_on";  // of the SBC: it is always on
    if (block.name == "sensors_in" && proglet && !known && !port && switchesOn(given)) {
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
      diagnostics.report(support::diagnostics::argumentWithoutEffect, given.name_range, given.name,
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
      diagnostics.report(support::diagnostics::sensorWithoutEffect, first.name_range, first.name);
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
      diagnostics.report(support::diagnostics::unknownBehaviour, block.range, block.name, flown());
    } else {
      diagnostics.report(support::diagnostics::behaviourWithoutEffect, block.range, block.name,
                         "the simulator does not know it");
    }
    return;
  }
  slocum::checkArguments(block, diagnostics);
  if (!hasEffect(block.name)) {
    diagnostics.report(support::diagnostics::behaviourWithoutEffect, block.range, block.name,
                       "the simulated vehicle does not have what it uses");
    return;
  }
  checkValues(block, diagnostics);
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
    const bool settings = !mission.sensors.empty() || !mission.setup.empty();
    diagnostics.report(
        settings ? support::diagnostics::settingsOnly : support::diagnostics::noBehaviours, place);
  }
  for (const slocum::Setting& sensor : mission.sensors) {
    if (!isRead(sensor.name)) {
      diagnostics.report(support::diagnostics::sensorWithoutEffect, sensor.name_range, sensor.name);
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
      diagnostics.report(support::diagnostics::secondHookbeh, block.range)
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
