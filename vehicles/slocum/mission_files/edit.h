// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/mission_files/mission_file.h"

#include <optional>
#include <string>
#include <string_view>

namespace glider::slocum {

/// A new value for one setting of a mission: a b_arg of a behaviour, or a sensor.
struct Edit {
  std::string behaviour;  ///< "sensor" for a sensor
  int number = 1;         ///< which of the behaviours of this name, from 1
  std::string setting;
  std::string value;  ///< a finite decimal number, as it is to be written
};

/// Reads `yo.d_target_depth=30`, `surface#2.when_secs=3600` or `sensor.u_mission_param_a=1`; empty
/// if `text` is not of this form.
std::optional<Edit> readEdit(std::string_view text);

/// The setting that `edit` is of, with its place in the .mi or .ma file that gives it; null if no
/// file does.
const Setting* findSetting(const MissionFile& mission, const Edit& edit);

/// `text` with the bytes of `range` replaced by `value`; every other byte stays as it is.
std::string withValue(std::string_view text, support::SourceRange range, std::string_view value);

}  // namespace glider::slocum
