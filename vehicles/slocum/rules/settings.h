// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "vehicles/slocum/mission_files/mission_file.h"

#include <optional>
#include <string>

namespace glider::slocum::rules {

/// Why a number of the vehicle's files keeps the way to the surface from being proved.
struct Doubt {
  std::string why;
  std::string change;
  support::SourceRange range;
};

/// The value of a setting, and where it is made: sensors_in stands above the mission's own lines
/// `sensor:`, and these above the vehicle's. 0 if it is made nowhere.
struct SettingInForce {
  double value = 0;
  support::SourceRange range;
};
SettingInForce settingInForce(const slocum::MissionFile& vehicle, std::string_view name);

/// A line `sensor:`, of the mission file or of autoexec.mi, that is not known to leave the way to
/// the surface as it is.
std::optional<Doubt> doubtfulSetting(const slocum::MissionFile& vehicle,
                                     const platforms::Platform& platform);

/// A sensor without which the vehicle does not know its depth or its pitch, and which it seldom or
/// never reads.
std::optional<Doubt> unreadSensor(const slocum::MissionFile& vehicle,
                                  const platforms::Platform& platform);

/// A b_arg of `block`, which `label` names, whose value is a mission parameter.
Doubt changesInFlight(const slocum::BehaviourBlock& block, const std::string& label,
                      std::string_view argument);

}  // namespace glider::slocum::rules
