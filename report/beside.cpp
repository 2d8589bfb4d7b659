// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/beside.h"

#include "report/figures.h"
#include "support/diagnostics/ids/command.h"
#include "support/trace/submersions.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

namespace glider::report {
namespace {

using support::Trace;

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// The time of the first row under water.
std::optional<double> firstDive(const Trace& trace) {
  const auto found = support::submersions(trace);
  return found.empty() ? std::nullopt : std::optional(trace.at(found[0].begin, 0));
}

/// Looks up values of a trace at ascending times.
class Reader {
 public:
  explicit Reader(const Trace& trace) : trace_(trace) {}

  /// The value of `column` at `time_s` on the line between two rows; NaN outside the trace.
  double at(int column, double time_s) {
    while (row_ + 1 < trace_.rowCount() && trace_.at(row_ + 1, 0) <= time_s) {
      ++row_;
    }
    if (column < 0 || row_ + 1 >= trace_.rowCount() || time_s < trace_.at(row_, 0)) {
      return kNoValue;
    }
    const double begin = trace_.at(row_, 0), end = trace_.at(row_ + 1, 0);
    const double from = trace_.at(row_, column), to = trace_.at(row_ + 1, column);
    return from + (to - from) * (time_s - begin) / (end - begin);
  }

 private:
  const Trace& trace_;
  size_t row_ = 0;
};

/// The first known value of `column` at or after `time_s`; 0 if there is none.
double valueFrom(const Trace& trace, int column, double time_s) {
  for (size_t row = 0; column >= 0 && row < trace.rowCount(); ++row) {
    if (trace.at(row, 0) >= time_s && std::isfinite(trace.at(row, column))) {
      return trace.at(row, column);
    }
  }
  return 0;
}

/// Where the flight's column `flown` is to be drawn from: its difference to the log's `logged` when
/// both begin to dive.
double offsetOf(const Trace& log, const char* logged, const Trace& flight, int flown,
                double shift_s) {
  const double dive_s = firstDive(log).value_or(0);
  return valueFrom(log, log.column(logged), dive_s) - valueFrom(flight, flown, dive_s - shift_s);
}

}  // namespace

support::Result<double> shiftBeside(const Trace& log, const Trace& flight,
                                    const std::string& name) {
  const auto logged = firstDive(log), flown = firstDive(flight);
  if (!logged || !flown) {
    return support::fail(
        support::diagnostics::noDiveToAlign, name,
        fmt::format("the {} never goes below {:.0f} m", flown ? "vehicle" : "simulated flight",
                    support::kSurfaceDepth));
  }
  return *logged - *flown;
}

void addBeside(Trace& log, const Trace& flight, double shift_s, const std::string& name) {
  const int east = flight.column("true_x"), north = flight.column("true_y");
  const bool track = east >= 0 && north >= 0 && log.column("dr_x") >= 0;
  const double x = offsetOf(log, "dr_x", flight, east, shift_s);
  const double y = offsetOf(log, "dr_y", flight, north, shift_s);
  const size_t width = log.columns.size();
  Reader reader(flight);
  std::vector<double> rows;
  rows.reserve(log.rows.size() / width * (width + 3));
  for (size_t row = 0; row < log.rowCount(); ++row) {
    const auto begin = log.rows.begin() + static_cast<std::ptrdiff_t>(row * width);
    rows.insert(rows.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
    const double time = log.at(row, 0) - shift_s;
    rows.push_back(reader.at(depthColumn(flight), time));
    rows.push_back(track ? reader.at(east, time) + x : kNoValue);
    rows.push_back(track ? reader.at(north, time) + y : kNoValue);
  }
  log.rows = std::move(rows);
  log.columns.insert(log.columns.end(), {{"sim_depth", "m"}, {"sim_x", "m"}, {"sim_y", "m"}});
  log.log->beside = name;
}

}  // namespace glider::report
