// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "vehicles/slocum/data_files/data_file.h"
#include "vehicles/slocum/data_files/sensor_lists.h"

#include <filesystem>
#include <string>
#include <vector>

namespace glider::slocum {

/// One data file with the time of each record.
struct LogFile {
  std::filesystem::path path;
  DataFile data;
  std::string vehicle;
  std::vector<double> times;  ///< s since 1970, by the computer's own clock; NaN: not known yet
  uint32_t first = 0;         ///< the first record that is more than initial values
  std::vector<bool> left_out = {};        ///< of each record: its time cannot be right
  std::vector<uint32_t> wild_fixes = {};  ///< records whose GPS fix cannot be right, ascending

  [[nodiscard]] bool isLeftOut(size_t record) const {
    return record < left_out.size() && left_out[record];
  }
  /// The first and the last known time of its records that are not left out; both NaN if there is
  /// none.
  [[nodiscard]] std::pair<double, double> span() const;
};

/// The files of one command line.
struct LogFiles {
  std::vector<LogFile> files;              ///< by vehicle and segment; flight, then science
  std::vector<support::Failure> failures;  ///< files that could not be read, and damage
  std::vector<std::string> skipped;        ///< why files were left out that could be read
  std::vector<support::Failure> warnings;  ///< of what is left out of the files
};

/// Reads the files, and the data files of the folders, in `paths`. Of several files of one computer
/// and segment (plain and compressed, .dbd and .sbd) the one with most sensors is kept.
LogFiles readLogFiles(const std::vector<std::filesystem::path>& paths, SensorLists& lists);

/// Splits files, which are in the order of their vehicles, by vehicle.
std::vector<std::vector<LogFile>> byVehicle(std::vector<LogFile> files);

}  // namespace glider::slocum
