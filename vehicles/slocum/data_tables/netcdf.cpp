// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_tables/netcdf.h"

#include "support/diagnostics/ids/files.h"
#include "support/files.h"
#include "vehicles/slocum/data_tables/netcdf_library.h"

#include <cstdlib>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace glider::slocum {
namespace {

constexpr int kDeflateLevel = 1;  // most of a column is fill values: more gains little

/// A netCDF file in memory, so that it is written whole or not at all. After an error the calls do
/// nothing, and the first error is kept.
class MemoryFile {
 public:
  /// `library` has all functions.
  explicit MemoryFile(const NetcdfLibrary& library) : nc_(library) {
    check(nc_.create_mem("glidercc", NC_NETCDF4 | NC_CLASSIC_MODEL, 0, &id_), "");
    open_ = good();
  }
  ~MemoryFile() {
    if (open_) {
      nc_.abort(id_);
    }
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int dimension(const char* name, size_t size) {
    int id = -1;
    run([&] { return nc_.def_dim(id_, name, size, &id); }, name);
    return id;
  }
  /// A compressed variable along `along`.
  int variable(const std::string& name, nc_type type, int along) {
    int id = -1;
    run([&] { return nc_.def_var(id_, name.c_str(), type, 1, &along, &id); }, name);
    run([&] { return nc_.def_var_deflate(id_, id, 1, 1, kDeflateLevel); }, name);
    return id;
  }
  void attribute(int variable, const char* name, std::string_view text) {
    run([&] { return nc_.put_att_text(id_, variable, name, text.size(), text.data()); }, name);
  }
  void fill(int variable, nc_type type, double value) {
    run([&] { return nc_.put_att_double(id_, variable, "_FillValue", type, 1, &value); }, "");
  }
  void attributeBytes(int variable, const char* name, const std::vector<signed char>& values) {
    run(
        [&] {
          return nc_.put_att_schar(id_, variable, name, NC_BYTE, values.size(), values.data());
        },
        name);
  }
  void endDefinitions() {
    run([&] { return nc_.enddef(id_); }, "");
  }
  void put(int variable, const std::vector<double>& values, const std::string& name) {
    const size_t start = 0, count = values.size();
    if (count > 0) {
      run([&] { return nc_.put_vara_double(id_, variable, &start, &count, values.data()); }, name);
    }
  }
  /// The library refuses to make a float of an infinity: they come as floats, as they are stored.
  void putFloats(int variable, const std::vector<double>& values, const std::string& name) {
    const size_t start = 0, count = values.size();
    std::vector<float> floats;
    for (const double value : values) {
      floats.push_back(static_cast<float>(value));
    }
    if (count > 0) {
      run([&] { return nc_.put_vara_float(id_, variable, &start, &count, floats.data()); }, name);
    }
  }
  /// The content of the finished file.
  std::string close() {
    NC_memio memory{};
    if (good()) {
      open_ = false;
      check(nc_.close_memio(id_, &memory), "");
    }
    const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
    return good() ? std::string(static_cast<const char*>(memory.memory), memory.size) : "";
  }
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  [[nodiscard]] bool good() const { return error_.empty(); }
  template <typename Call>
  void run(Call call, const std::string& name) {
    if (good()) {
      check(call(), name);
    }
  }
  void check(int status, const std::string& name) {
    if (status != NC_NOERR) {
      error_ = (name.empty() ? "" : "`" + name + "`: ") + nc_.strerror(status);
    }
  }

  const NetcdfLibrary& nc_;
  int id_ = -1;
  bool open_ = false;
  std::string error_;
};

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
  const NetcdfLibrary& library = NetcdfLibrary::get();
  if (!library.error.empty()) {
    return support::fail(support::diagnostics::cannotWrite, path.string(), library.error);
  }
  MemoryFile out(library);
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
