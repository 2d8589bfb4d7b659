// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/json_document.h"
#include "report/picture/picture.h"

#include <string>
#include <vector>

namespace glider::driver {

/// What `glidercc log` was given.
struct DataLogOptions {
  std::vector<std::string> files;
  std::string csv;                   ///< empty: none; "-": standard output
  std::string netcdf;                ///< empty: none
  std::vector<std::string> sensors;  ///< patterns; empty: all
  std::vector<std::string> caches;
  std::string report;   ///< empty: none
  std::string picture;  ///< empty: none
  report::PictureStyle picture_style;
  std::string mission;  ///< that wrote the log; empty: not given
  std::string beside;   ///< the trace.csv of a simulated flight; empty: none
};

/// True for data files of the vehicle; false for a single file of another kind.
bool areDataFiles(const std::vector<std::string>& files);
/// Shows the data files, puts them into `document` (null: none), or writes them as CSV and netCDF;
/// returns the exit code.
int showDataFiles(const DataLogOptions& options, Json* document);

}  // namespace glider::driver
