// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/export/export.h"
#include "report/figures.h"
#include "report/text.h"
#include "support/diagnostics/ids/files.h"
#include "support/files.h"
#include "support/netcdf/memory_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace glider::report {
namespace {

using support::NetcdfMemoryFile;
using support::Trace;

struct Pair {
  std::string_view from, to;
};
constexpr auto kStandardNames = std::to_array<Pair>({
#define CF_NAME(column, name) {column, name},
#define CF_UNIT(from, to)
#include "report/export/cf_names.def"
#undef CF_NAME
#undef CF_UNIT
});
constexpr auto kUnits = std::to_array<Pair>({
#define CF_NAME(column, name)
#define CF_UNIT(from, to) {from, to},
#include "report/export/cf_names.def"
#undef CF_NAME
#undef CF_UNIT
});

/// A coordinate of the trajectory: the variable, the column that it is made from, and what CF
/// requires to know of it.
struct Coordinate {
  const char* name;
  const char* column;
  const char* standard_name;
  const char* units;
  const char* axis;
};
constexpr std::array<Coordinate, 4> kCoordinates = {{
    {"time", "time", "time", "seconds since 1970-01-01 00:00:00 UTC", "T"},
    {"lat", "true_lat", "latitude", "degrees_north", "Y"},
    {"lon", "true_lon", "longitude", "degrees_east", "X"},
    {"depth", "true_depth", "depth", "m", "Z"},
}};
constexpr double kFill = std::numeric_limits<double>::quiet_NaN();

std::vector<double> valuesOf(const Trace& trace, int column, double offset = 0) {
  std::vector<double> values;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    values.push_back(trace.at(row, column) + offset);
  }
  return values;
}

/// Dives and climbs, numbered from 1 on.
std::vector<double> profilesOf(const Trace& trace) {
  std::vector<double> numbers(trace.rowCount(), 1);
  const auto turns = turningPoints(trace);
  double number = 1;
  size_t next = 0;
  for (size_t row = 0; row < numbers.size(); ++row) {
    for (; next < turns.size() && turns[next].row < row; ++next) {
      number += turns[next].row > 0 ? 1 : 0;  // the first may be the start
    }
    numbers[row] = number;
  }
  return numbers;
}

/// One variable of the file, to be filled when all are defined.
struct Variable {
  int id;
  std::string name;
  std::vector<double> values;
};

class FlightFile {
 public:
  explicit FlightFile(const Trace& trace) : trace_(trace) {}

  support::Result<void> write(const std::filesystem::path& path) {
    along_ = out_.dimension("time", trace_.rowCount());
    describe();
    defineCoordinates();
    defineProfiles();
    for (size_t i = 0; i < trace_.columns.size(); ++i) {
      defineColumn(i);
    }
    out_.endDefinitions();
    for (const Variable& variable : variables_) {
      out_.put(variable.id, variable.values, variable.name);
    }
    const std::string content = out_.close();
    if (!out_.error().empty()) {
      return support::fail(support::diagnostics::cannotWrite, path.string(), out_.error());
    }
    return support::writeFileAtomically(path, content);
  }

 private:
  void describe() {
    out_.attribute(NC_GLOBAL, "Conventions", "CF-1.8");
    out_.attribute(NC_GLOBAL, "featureType", "trajectory");
    out_.attribute(NC_GLOBAL, "title", plain(flightTitle(trace_)));
    out_.attribute(NC_GLOBAL, "source",
                   fmt::format("flight simulated by glidercc, scenario {}, seed {}",
                               plain(trace_.scenario), trace_.seed));
    out_.attribute(NC_GLOBAL, "comment",
                   "lat, lon and depth are the true ones; other variables have the names of the "
                   "vehicle's sensors");
  }

  void defineCoordinates() {
    for (const Coordinate& coordinate : kCoordinates) {
      const int column = trace_.column(coordinate.column);
      if (column < 0) {
        continue;
      }
      const int id = out_.variable(coordinate.name, NC_DOUBLE, along_);
      const bool time = std::string_view(coordinate.name) == "time";
      if (!time) {  // a coordinate variable has no missing values
        out_.fill(id, NC_DOUBLE, kFill);
      }
      out_.attribute(id, "standard_name", coordinate.standard_name);
      out_.attribute(id, "units", coordinate.units);
      out_.attribute(id, "axis", coordinate.axis);
      if (time) {
        out_.attribute(id, "calendar", "standard");
      }
      if (std::string_view(coordinate.name) == "depth") {
        out_.attribute(id, "positive", "down");
      }
      coordinates_ += coordinates_.empty() ? "" : " ";
      coordinates_ += coordinate.name;
      variables_.push_back(
          {id, coordinate.name, valuesOf(trace_, column, time ? trace_.start_utc_s : 0)});
    }
    const int trajectory = out_.scalar("trajectory", NC_INT);
    out_.attribute(trajectory, "cf_role", "trajectory_id");
    out_.attribute(trajectory, "long_name", "number of the flight");
    variables_.push_back({trajectory, "trajectory", {1}});
  }

  void defineProfiles() {
    const int id = out_.variable("profile_index", NC_INT, along_);
    out_.attribute(id, "long_name", "number of the dive or climb");
    out_.attribute(id, "units", "1");
    out_.attribute(id, "coordinates", coordinates_);
    variables_.push_back({id, "profile_index", profilesOf(trace_)});
  }

  void defineColumn(size_t number) {
    const support::TraceColumn& column = trace_.columns[number];
    if (std::ranges::any_of(kCoordinates,
                            [&](const Coordinate& c) { return column.name == c.column; })) {
      return;
    }
    const int id = out_.variable(column.name, NC_DOUBLE, along_);
    out_.fill(id, NC_DOUBLE, kFill);
    const auto standard = std::ranges::find(kStandardNames, column.name, &Pair::from);
    if (standard != kStandardNames.end()) {
      out_.attribute(id, "standard_name", standard->to);
    }
    out_.attribute(id, "long_name", longNameOf(column.name));
    const auto unit = std::ranges::find(kUnits, column.unit, &Pair::from);
    out_.attribute(id, "units", unit != kUnits.end() ? unit->to : std::string_view(column.unit));
    out_.attribute(id, "coordinates", coordinates_);
    if (column.name == "state") {
      describeStates(id);
    }
    variables_.push_back({id, column.name, valuesOf(trace_, static_cast<int>(number))});
  }

  /// Of a logged value, the statement; else the name with spaces.
  [[nodiscard]] std::string longNameOf(const std::string& column) const {
    const auto& logged = trace_.facts.logged;
    const auto found = std::ranges::find(logged, column, &support::LoggedValue::column);
    if (found != logged.end()) {
      return plain(found->text + ": " + found->value);
    }
    std::string name = column;
    std::ranges::replace(name, '_', ' ');
    return name;
  }

  void describeStates(int id) {
    std::string names;
    for (size_t i = 0; i < trace_.state_names.size(); ++i) {
      names += fmt::format("{}{} {}", names.empty() ? "" : ", ", i, plain(trace_.state_names[i]));
    }
    out_.attribute(id, "comment", "state of the mission: " + names);
  }

  const Trace& trace_;
  NetcdfMemoryFile out_;
  int along_ = -1;
  std::string coordinates_;  ///< the names of the coordinates, separated by spaces
  std::vector<Variable> variables_;
};

}  // namespace

support::Result<void> writeFlightNetcdf(const Trace& trace, const std::filesystem::path& path) {
  return FlightFile(trace).write(path);
}

}  // namespace glider::report
