// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/mission_files/mission_file.h"
#include "vehicles/slocum/rules/settings.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::slocum::rules {

/// How often the flight controller must read one of its sensors for hookbeh: the table of
/// docs/verification.md.
struct SensorNeed {
  std::string_view setting;  ///< of sensors_in, or of a line `sensor:`; s, negative: never
  double slowest_s = 0;
  std::string_view never;   ///< what hookbeh does if it is never read
  std::string_view seldom;  ///< and if it is read less often
  bool altimeter = false;   ///< not needed if min_altitude is negative
};
const std::vector<SensorNeed>& sensorNeeds();

/// Those of `vehicle` that do not meet a row, with the behaviour or line that sets it.
std::vector<Doubt> unmetNeeds(const slocum::MissionFile& vehicle);

}  // namespace glider::slocum::rules
