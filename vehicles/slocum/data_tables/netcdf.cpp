// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_tables/netcdf.h"

#include "support/diagnostics/ids/files.h"
#include "support/files.h"
#include "support/netcdf/memory_file.h"

#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace glider::slocum {
namespace {

using MemoryFile = support::NetcdfMemoryFile;

/// How a sensor of some width is stored. Integers are one size larger, to have a fill value that no
/// reading has.
struct Storage {
  nc_type type;
  double fill;
};

Storage storageOf(uint8_t width) {
  switch (width) {
    case 1:
      return {NC_SHORT, std::numeric_limits<int16_t>::min()};
    case 2:
      return {NC_INT, std::numeric_limits<int32_t>::min()};
    case 4:
      return {NC_FLOAT, std::numeric_limits<double>::quiet_NaN()};
    default:
      return {NC_DOUBLE, std::numeric_limits<double>::quiet_NaN()};
  }
}

/// Each different one of what `text` gives for the files, in their order.
template <typename Text>
std::string listOf(const std::vector<LogFile>& files, Text text) {
  std::string list;
  std::set<std::string> seen;
  for (const LogFile& file : files) {
    if (const std::string one = text(file); seen.insert(one).second) {
      list += (list.empty() ? "" : " ") + one;
    }
  }
  return list;
}

void describeFile(MemoryFile& out, const std::vector<LogFile>& files) {
  out.attribute(NC_GLOBAL, "title", "Data files of a Slocum glider, a row for each record");
  out.attribute(NC_GLOBAL, "vehicle", listOf(files, [](const LogFile& f) { return f.vehicle; }));
  out.attribute(NC_GLOBAL, "mission",
                listOf(files, [](const LogFile& f) { return f.data.header.mission; }));
  out.attribute(NC_GLOBAL, "segments",
                listOf(files, [](const LogFile& f) { return f.data.header.full_name; }));
  out.attribute(NC_GLOBAL, "source",
                listOf(files, [](const LogFile& f) { return f.path.filename().string(); }));
}

/// Variables of the rows themselves: when, and which computer.
struct RowVariables {
  int time = -1;
  int computer = -1;
};

RowVariables defineRows(MemoryFile& out, int along) {
  RowVariables rows;
  rows.time = out.variable("time", NC_DOUBLE, along);
  out.fill(rows.time, NC_DOUBLE, std::numeric_limits<double>::quiet_NaN());
  out.attribute(rows.time, "standard_name", "time");
  out.attribute(rows.time, "units", "seconds since 1970-01-01 00:00:00 UTC");
  out.attribute(rows.time, "calendar", "standard");
  rows.computer = out.variable("computer", NC_BYTE, along);
  out.attribute(rows.computer, "long_name", "computer that wrote the record");
  out.attributeBytes(rows.computer, "flag_values", {0, 1});
  out.attribute(rows.computer, "flag_meanings", "flight science");
  return rows;
}

int defineSensor(MemoryFile& out, int along, const MergedColumn& column) {
  const Storage storage = storageOf(column.sensor.width);
  const int id = out.variable(column.name, storage.type, along);
  out.fill(id, storage.type, storage.fill);
  out.attribute(id, "units", column.sensor.unit);
  out.attribute(id, "computer", column.computer == Computer::Flight ? "flight" : "science");
  if (column.sensor.unit == "lat" || column.sensor.unit == "lon") {
    out.attribute(id, "comment", "degrees and minutes, dddmm.mmmm");
  }
  return id;
}

void putRows(MemoryFile& out, const Merged& merged, const RowVariables& rows) {
  std::vector<double> times, computers;
  for (const MergedRow& row : merged.rows) {
    times.push_back(row.time);
    computers.push_back(merged.files[row.file].data.computer == Computer::Flight ? 0 : 1);
  }
  out.put(rows.time, times, "time");
  out.put(rows.computer, computers, "computer");
}

}  // namespace

support::Result<void> writeNetcdf(const Merged& merged, const std::filesystem::path& path) {
  MemoryFile out;
  const int along = out.dimension("time", merged.rows.size());
  describeFile(out, merged.files);
  const RowVariables rows = defineRows(out, along);
  std::vector<int> sensors;
  for (const MergedColumn& column : merged.columns) {
    sensors.push_back(defineSensor(out, along, column));
  }
  out.endDefinitions();
  putRows(out, merged, rows);
  for (size_t i = 0; i < sensors.size(); ++i) {
    const MergedColumn& column = merged.columns[i];
    const Storage storage = storageOf(column.sensor.width);
    std::vector<double> values(merged.rows.size(), storage.fill);
    merged.forEachUpdateOf(i, [&](uint32_t row, double value) { values[row] = value; });
    storage.type == NC_FLOAT ? out.putFloats(sensors[i], values, column.name)
                             : out.put(sensors[i], values, column.name);
  }
  const std::string content = out.close();
  if (!out.error().empty()) {
    return support::fail(support::diagnostics::cannotWrite, path.string(), out.error());
  }
  return support::writeFileAtomically(path, content);
}

}  // namespace glider::slocum
