// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/check/check.h"
#include "flights/launch_choice.h"
#include "report/picture/picture.h"
#include "vehicles/slocum/data_tables/log_files.h"

#include <string>
#include <vector>

namespace glider::driver {

/// What `glidercc check --against` was given.
struct AgainstOptions {
  std::vector<std::string> logs;  ///< data files and folders of them; empty: none
  std::vector<std::string> caches;
  flights::LaunchChoice launch;
  std::string page;     ///< file; empty: none
  std::string picture;  ///< file; empty: none
  report::PictureStyle picture_style;
};

/// The data files of a command line.
struct VehicleLogs {
  std::vector<std::vector<slocum::LogFile>> vehicles;
  int status = 0;  ///< exit code: kWorldFailed if a file could not be read as a whole
};

/// Reads the data files; reports those that are damaged or cannot be read.
VehicleLogs readVehicleLogs(const AgainstOptions& options);

/// Adds what the mission would have done with each vehicle's readings to the findings, if it has no
/// errors.
void runAgainst(const VehicleLogs& logs, const AgainstOptions& options,
                analysis::CheckedFile& checked);

/// Draws the findings of runAgainst as the options say: as a picture, and as marks on the report
/// page of the logs. GL9365: there are several vehicles.
support::Result<void> drawAgainst(const VehicleLogs& logs, const AgainstOptions& options,
                                  const analysis::CheckedFile& checked);

}  // namespace glider::driver
