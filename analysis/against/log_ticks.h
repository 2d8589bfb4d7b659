// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/eval/interpreter.h"
#include "platforms/load/platform.h"
#include "vehicles/slocum/data_tables/log_files.h"

#include <cstdint>
#include <vector>

namespace glider::analysis {

/// One tick of a mission along data files.
struct LogTick {
  double utc_s = 0;                ///< since 1970, by the clock of the computer whose record it is
  double time_s = 0;               ///< since the first tick
  double depth_m = 0;              ///< m_depth, if it is in its range and not stale; otherwise NaN
  std::vector<double> quantities;  ///< those of report::pictureQuantities(), in the vehicle's units
  std::vector<ir::SensorUpdate> frame;
};

/// What the data files hold of a sensor of the mission.
struct SensorInLogs {
  bool present = false;  ///< some file has the sensor
  uint32_t updates = 0;
};

/// All ticks of a mission along the data files of one vehicle; the first is the start.
struct LogTicks {
  std::vector<LogTick> ticks;
  std::vector<SensorInLogs> sensors;  ///< one for each of the mission
  bool science = false;               ///< there are no records of the flight computer
};

/// The ticks of `mission` along the data files of one vehicle. A tick is a record of the flight
/// computer, which is one cycle of it; its frame holds what the records since the one before have
/// updated, also those of the science computer. Headings are from true north (ir/README.md, D3).
/// `every_s` and `dead_band` of the platform reduce the readings as hookprog does. Records of
/// initial values, and what follows the last tick, are left out.
LogTicks ticksAlong(const std::vector<slocum::LogFile>& files, const ir::Mission& mission,
                    const platforms::Platform& platform);

}  // namespace glider::analysis
