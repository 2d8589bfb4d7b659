// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/logged_form.h"
#include "logs/render.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace glider::driver {

/// The values in a mission's log with their units, which are in the mission and not in the log.
class LogInUnits {
 public:
  explicit LogInUnits(const compiler::Optimised& mission);

  /// "depth 11.779 m, temp unknown"; "39 10.500 N 73 50.101 W": the values of `entry`. What the
  /// mission does not name has no unit.
  [[nodiscard]] std::string values(const logs::LogEntry& entry);
  /// The same entry with its values in the units that it then names; positions are in degrees.
  [[nodiscard]] logs::LogEntry converted(const logs::LogEntry& entry);
  /// How many entries had something that the mission does not name: another version wrote them.
  [[nodiscard]] size_t strangers() const { return strangers_; }

 private:
  std::vector<flights::LoggedForm> formsOf(const logs::LogEntry& entry);
  void nameSensors(const ir::Mission& mission, const flights::SensorUnit& unit);
  void nameNotes(const ir::Mission& mission, const flights::SensorUnit& unit);

  std::map<std::string, flights::LoggedForm> named_;
  /// By text and count of values.
  std::map<std::pair<std::string, size_t>, std::vector<flights::LoggedForm>> notes_;
  size_t strangers_ = 0;
};

}  // namespace glider::driver
