// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_manager.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The Slocum's own mission files as plain data. Names are kept in lower case: the vehicle ignores
/// case.
namespace glider::slocum {

/// `name(unit) value` of a sensor or b_arg line. The unit is a description only and means nothing
/// to the vehicle.
struct Setting {
  std::string name;
  std::string unit;
  double value = 0;
  support::SourceRange name_range;
  support::SourceRange value_range;
};

/// One `behavior:` line with its `b_arg:` lines.
struct BehaviourBlock {
  std::string name;
  support::SourceRange range;  ///< of the name
  std::vector<Setting> arguments;

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
  std::vector<BehaviourBlock> behaviours;
  std::vector<SetupLine> setup;
};

/// One line of a waypoint list, ddmm.mmmm as on the vehicle.
struct Waypoint {
  double longitude_ddmm = 0;
  double latitude_ddmm = 0;
};

/// A .ma file.
struct ArgumentFile {
  std::string behaviour;
  support::SourceRange behaviour_range;
  std::vector<Setting> arguments;
  std::vector<Waypoint> waypoints;
};

}  // namespace glider::slocum
