// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_range.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The Slocum's own mission files as plain data. Names are kept in lower case: the vehicle ignores
/// case.
namespace glider::slocum {

/// A position that was never set, in lat and lon.
inline constexpr double kUnsetPosition = 69696969;

/// The mission parameters u_mission_param_a to z.
inline constexpr int kMissionParameters = 26;

/// A b_arg of 1000000 or more is not a number but a mission parameter, which the vehicle reads at
/// run time: 1000000 is u_mission_param_a, number 0. Empty for a number.
constexpr std::optional<int> missionParameter(double value) {
  constexpr double kFirst = 1'000'000;
  return value >= kFirst && value < kFirst + kMissionParameters
             ? std::optional(static_cast<int>(value - kFirst))
             : std::nullopt;
}

/// `name(unit) value` of a sensor or b_arg line. The unit is a description only and means nothing
/// to the vehicle.
struct Setting {
  std::string name;
  std::string unit;
  double value = 0;
  support::SourceRange name_range;
  support::SourceRange value_range;
};

/// One line of a waypoint list, ddmm.mmmm as on the vehicle.
struct Waypoint {
  double longitude_ddmm = 0;
  double latitude_ddmm = 0;
};

/// One `behavior:` line with its `b_arg:` lines.
struct BehaviourBlock {
  std::string name;
  support::SourceRange range;  ///< of the name
  std::vector<Setting> arguments;
  std::vector<Waypoint> waypoints = {};  ///< of its .ma file
  bool lacks_file = false;               ///< its .ma file is missing: it has no effect

  [[nodiscard]] const Setting* find(std::string_view argument) const;
  /// The value of `argument`, else the default of the catalogue (behaviours.def).
  [[nodiscard]] double value(std::string_view argument) const;
};

/// A line of autoexec.mi: `name X`, `installed DEV [0|1]`, `use DEV [0|1] …`, kept as its words.
struct SetupLine {
  std::vector<std::string> words;
  support::SourceRange range;
};

/// A .mi file: behaviours in the order of the file, the first has the highest priority.
struct MissionFile {
  std::vector<Setting> sensors;
  std::vector<Setting> vehicle_sensors = {};  ///< of autoexec.mi; each stands below `sensors`
  std::vector<BehaviourBlock> behaviours;
  std::vector<SetupLine> setup;
};

/// Raises `overtime` of abend to `seconds` if it is sooner; returns what it was, empty if it was
/// not.
std::optional<double> raiseOvertime(MissionFile& mission, double seconds);

/// Raises `nap_secs` of hookbeh to `seconds` if it is shorter; returns what it is then, empty if it
/// was not.
std::optional<double> raiseNapSecs(MissionFile& mission, double seconds);

/// A .ma file.
struct ArgumentFile {
  std::string behaviour;
  support::SourceRange behaviour_range;
  std::vector<Setting> arguments;
  std::vector<Waypoint> waypoints;
};

}  // namespace glider::slocum
