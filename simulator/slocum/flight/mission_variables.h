// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/mission_files/mission_file.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace glider::simulator {

/// How deep the vehicle may work, m: a setting that limits targets and overdepth.
inline constexpr std::string_view kWorkingDepth = "f_max_working_depth";

/// The vehicle's sensors that are settings of its mission: those of autoexec.mi, above them
/// those of the `sensor:` lines, above them those of the behaviour sensors_in; the mission
/// parameters u_mission_param_a to z and the mission mode. One that was never set is 0, as on the
/// vehicle.
class MissionVariables {
 public:
  explicit MissionVariables(const slocum::MissionFile& mission);

  [[nodiscard]] double get(std::string_view name) const;
  /// Empty for one that was never set. A mission parameter (slocum::missionParameter) is read.
  [[nodiscard]] std::optional<double> find(std::string_view name) const;
  void set(std::string_view name, double value) { values_[std::string(name)] = value; }
  /// The value of mission parameter `number` (0 is a); the address stays valid.
  [[nodiscard]] const double* parameter(int number) const;

 private:
  std::map<std::string, double, std::less<>> values_;
};

/// A b_arg: a number, or a mission parameter that is read whenever the b_arg is used.
class Argument {
 public:
  Argument(double given, const MissionVariables& variables);

  [[nodiscard]] double operator()() const { return parameter_ != nullptr ? *parameter_ : value_; }

 private:
  double value_;
  const double* parameter_;  ///< null: a number
};

}  // namespace glider::simulator
