// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "slocum/data_traces/flight_trace.h"

#include "slocum/data_traces/depth.h"
#include "slocum/data_traces/events.h"
#include "slocum/data_traces/position.h"
#include "slocum/data_traces/quantities.h"
#include "slocum/data_traces/samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::slocum {
namespace {

using support::DiagnosticId;
using support::Result;
using support::Trace;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
// UTC, s: records from before are by a clock that was not set, later ones damaged.
constexpr double kYear2000 = 946684800, kYear2100 = 4102444800;

/// Adds those of `more` to `times`, which is sorted, that have none within kNear.
void addTimes(const std::vector<double>& more, std::vector<double>& times) {
  const std::vector<double> before = times;
  for (const double time : more) {
    const auto near = std::ranges::lower_bound(before, time - kNear);
    if (near == before.end() || *near > time + kNear) {
      times.push_back(time);
    }
  }
  std::ranges::sort(times);
  times.erase(std::ranges::unique(times).begin(), times.end());
}

/// The times of the rows, ascending, since 1970.
std::vector<double> rowTimes(const Merged& merged, const std::vector<double>& more_times_s) {
  std::vector<double> flight, science;
  for (const MergedRow& row : merged.rows) {
    if (row.time > kYear2000 && row.time < kYear2100) {
      const bool of_flight = merged.files[row.file].data.computer == Computer::Flight;
      (of_flight ? flight : science).push_back(row.time);
    }
  }
  addTimes(science, flight);
  if (!flight.empty()) {
    std::vector<double> during = more_times_s;
    std::erase_if(during, [&](double t) { return t < flight.front() || t > flight.back(); });
    addTimes(during, flight);
  }
  return flight;
}

/// Adds a time in the middle of each gap in which nothing was recorded, where all is unknown; says
/// which times those are.
std::vector<bool> addGaps(std::vector<double>& times) {
  std::vector<double> out;
  std::vector<bool> in_gap;
  for (const double time : times) {
    if (!out.empty() && time - out.back() > kLongestGap) {
      out.push_back((out.back() + time) / 2);
      in_gap.push_back(true);
    }
    out.push_back(time);
    in_gap.push_back(false);
  }
  times = std::move(out);
  return in_gap;
}

/// The names of the missions, each once: "SPIRAL.MI, NSB3.MI".
std::string missionsOf(const std::vector<LogFile>& files) {
  constexpr size_t kMost = 3;
  std::vector<std::string> names;
  for (const LogFile& file : files) {
    if (std::ranges::find(names, file.data.header.mission) == names.end()) {
      names.push_back(file.data.header.mission);
    }
  }
  std::string text;
  for (size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    text += (text.empty() ? "" : ", ") + names[i];
  }
  return names.size() > kMost ? text + " and others" : text;
}

void addRows(const std::vector<double>& times, const std::vector<bool>& in_gap,
             const std::vector<FlightColumn>& columns, Trace& trace) {
  trace.columns = {{"time", "s"}};
  for (const FlightColumn& column : columns) {
    trace.columns.push_back(column.column);
  }
  for (size_t i = 0; i < times.size(); ++i) {
    trace.rows.push_back(times[i] - times[0]);
    for (const FlightColumn& column : columns) {
      trace.rows.push_back(in_gap[i] ? kUnknown : column.values[i]);
    }
  }
}

}  // namespace

std::vector<std::string> flightTraceSensors() {
  std::vector<std::string> names;
  for (const auto& more : {depthSensors(), positionSensors(), quantitySensors(), eventSensors()}) {
    names.insert(names.end(), more.begin(), more.end());
  }
  return names;
}

Result<Trace> flightTrace(const Merged& merged, const std::vector<double>& more_times_s) {
  const Samples depth = depthOf(merged);
  std::vector<double> times = rowTimes(merged, more_times_s);
  if (times.empty()) {
    return support::fail(DiagnosticId::noDepthLogged, "no record has a valid time");
  }
  const std::vector<bool> in_gap = addGaps(times);
  Trace trace;
  trace.mission = missionsOf(merged.files);
  trace.state_names = {"surface", "dive", "climb", "hover"};
  trace.log = {.vehicle = merged.files[0].vehicle, .utc_s = times[0], .beside = "", .notes = {}};
  std::vector<FlightColumn> columns = {{{"m_depth", "m"}, resampled(depth, times, Between::Line)}};
  if (std::ranges::all_of(columns[0].values, [](double value) { return std::isnan(value); })) {
    return support::fail(DiagnosticId::noDepthLogged, "they do not contain the vehicle's depth");
  }
  std::string note;
  for (auto more : {quantities(merged, times), positions(merged, times),
                    currents(merged, depth, times, note)}) {
    std::ranges::move(more, std::back_inserter(columns));
  }
  std::erase_if(columns, [](const FlightColumn& column) {
    return std::ranges::all_of(column.values, [](double value) { return std::isnan(value); });
  });
  addRows(times, in_gap, columns, trace);
  if (!note.empty()) {
    trace.log->notes.push_back(note);
  }
  addEvents(merged, trace);
  return trace;
}

}  // namespace glider::slocum
