// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/mission_variables.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

namespace glider::simulator {

/// The settings that say how often the flight controller reads a device of its own, s: 0 in each
/// cycle, negative never. The behaviour sensors_in sets them.
inline constexpr std::array<std::string_view, 7> kDeviceSettings = {
    "c_att_time",    "c_pressure_time",   "c_alt_time", "u_battery_time",
    "u_vacuum_time", "c_leakdetect_time", "c_gps_on",
};

inline bool isDeviceSetting(std::string_view name) {
  return std::ranges::find(kDeviceSettings, name) != kDeviceSettings.end();
}

/// When a device is read, by its setting.
class Device {
 public:
  explicit Device(std::string_view setting) : setting_(setting) {}

  /// True in a cycle in which it is read; call once a cycle.
  bool due(const MissionVariables& variables, double now_s) {
    const double period_s = variables.find(setting_).value_or(0);
    if (period_s < 0 || now_s - read_s_ < period_s) {
      return false;
    }
    read_s_ = now_s;
    return true;
  }

 private:
  std::string_view setting_;
  double read_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace glider::simulator
