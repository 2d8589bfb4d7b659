// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/slocum/data_tables/log_files.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace glider::slocum {

/// A sensor of one computer, in all files of a vehicle.
struct MergedColumn {
  std::string name;  ///< where both computers have a sensor, the copy is gld_dup_ or sci_dup_
  Sensor sensor;
  Computer computer = Computer::Flight;
  /// The first file with the sensor has it in another unit: `name` ends with the unit.
  bool of_other_unit = false;
};

/// One record of one file.
struct MergedRow {
  double time = 0;
  uint32_t file = 0;
  uint32_t record = 0;
};

/// The files of one vehicle as one table: a row for each record, by time. Records of initial
/// values, and records and GPS fixes that cannot be right (LogFile), are left out.
struct Merged {
  const std::vector<LogFile>& files;
  std::vector<MergedColumn> columns;  ///< by name
  std::vector<MergedRow> rows;        ///< by time, as far as it is known
  /// Row of each record from `first` on that is not left out, for each file.
  std::vector<std::vector<uint32_t>> row_of;
  std::vector<std::vector<size_t>> in_file;  ///< column in each file; kNone: it is not there

  static constexpr size_t kNone = SIZE_MAX;

  /// Calls `take(row, value)` for each update of a column, file by file.
  template <typename Take>
  void forEachUpdateOf(size_t column, Take take) const {
    const bool is_fix = isSameName(columns[column].sensor.name, "m_gps_lat") ||
                        isSameName(columns[column].sensor.name, "m_gps_lon");
    for (size_t i = 0; i < files.size(); ++i) {
      const size_t at = in_file[i][column];
      if (at == kNone) {
        continue;
      }
      const uint32_t first = files[i].first;
      forEachUpdate(files[i].data, at, [&](uint32_t record, Update, double value) {
        const bool left_out = record < first || files[i].isLeftOut(record) ||
                              (is_fix && std::ranges::binary_search(files[i].wild_fixes, record));
        if (!left_out) {
          take(row_of[i][record - first], value);
        }
      });
    }
  }
};

/// What a column held before the first row, from the records of initial values; NaN: nothing.
double initialValue(const Merged& merged, size_t column);

/// True if `name` matches `pattern`, in which `*` stands for any characters. Case does not matter.
bool matches(std::string_view name, std::string_view pattern);

/// All sensors of the files, by name.
std::vector<MergedColumn> columnsOf(std::span<const LogFile> files);

/// Merges `files`, with the columns whose names match one of `patterns` (all if there are none).
Merged merge(const std::vector<LogFile>& files, const std::vector<std::string>& patterns);

/// A value as text, as short as the sensor's width permits: reading it gives the same value.
std::string valueText(double value, uint8_t width);

}  // namespace glider::slocum
