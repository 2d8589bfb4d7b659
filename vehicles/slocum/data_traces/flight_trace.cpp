// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_traces/flight_trace.h"

#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/slocum/data_traces/depth.h"
#include "vehicles/slocum/data_traces/events.h"
#include "vehicles/slocum/data_traces/position.h"
#include "vehicles/slocum/data_traces/quantities.h"
#include "vehicles/slocum/data_traces/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace glider::slocum {
namespace {

using support::Result;
using support::Trace;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
// UTC, s: records from before are by a clock that was never set, later ones damaged.
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

/// The times of the rows that are records, ascending, since 1970.
std::vector<double> recordTimes(const Merged& merged) {
  std::vector<double> flight, science;
  for (const MergedRow& row : merged.rows) {
    if (row.time > kYear2000 && row.time < kYear2100) {
      const bool of_flight = merged.files[row.file].data.computer == Computer::Flight;
      (of_flight ? flight : science).push_back(row.time);
    }
  }
  addTimes(science, flight);
  return flight;
}

/// The times of the records on both sides of those that are missing because of damage.
std::vector<std::pair<double, double>> breaksOf(const std::vector<LogFile>& files) {
  std::vector<std::pair<double, double>> breaks;
  for (const LogFile& file : files) {
    for (const uint32_t record : file.data.breaks) {
      if (record > file.first && record < file.times.size()) {
        breaks.emplace_back(file.times[record - 1], file.times[record]);
      }
    }
  }
  return breaks;
}

/// The gaps between records, since the first of them: long ones, and those of damage.
std::vector<support::TraceGap> gapsBetween(const std::vector<double>& times,
                                           const std::vector<std::pair<double, double>>& breaks) {
  std::vector<support::TraceGap> gaps;
  for (size_t i = 1; i < times.size(); ++i) {
    const bool damage =
        std::ranges::find(breaks, std::pair(times[i - 1], times[i])) != breaks.end();
    if (damage || times[i] - times[i - 1] > kLongestGap) {
      gaps.push_back({times[i - 1] - times[0], times[i] - times[0]});
    }
  }
  return gaps;
}

/// What is left out of the files, for the reader.
std::vector<std::string> leftOutOf(const std::vector<LogFile>& files) {
  size_t records = 0, fixes = 0, breaks = 0;
  for (const LogFile& file : files) {
    records += static_cast<size_t>(std::ranges::count(file.left_out, true));
    fixes += file.wild_fixes.size();
    breaks += file.data.breaks.size();
  }
  std::vector<std::string> notes;
  const auto add = [&](size_t count, const char* one, const char* many, const char* what) {
    if (count > 0) {
      notes.push_back(fmt::format("{} {} {}", count, count == 1 ? one : many, what));
    }
  };
  add(records, "record is", "records are", "left out, because of a time that cannot be right");
  add(fixes, "GPS fix is", "GPS fixes are", "left out, because of a position that cannot be right");
  add(breaks, "gap is", "gaps are", "in the records where a file is damaged");
  return notes;
}

/// Adds to `times` those of `more_times_s` during them, and a time in the middle of each gap: no
/// line may cross it.
void addBetween(const std::vector<double>& more_times_s, const std::vector<support::TraceGap>& gaps,
                std::vector<double>& times) {
  const double first = times.front(), last = times.back();
  std::vector<double> during = more_times_s;
  std::erase_if(during, [&](double t) { return t < first || t > last; });
  addTimes(during, times);
  std::vector<double> middles;
  for (const support::TraceGap& gap : gaps) {
    middles.push_back(first + (gap.from_s + gap.to_s) / 2);
  }
  addTimes(middles, times);
}

/// Whether a time since the first record lies between two records with a gap between them.
bool isInGap(const Trace& trace, double time_s) {
  const auto isAround = [&](const support::TraceGap& gap) {
    return gap.from_s < time_s && time_s < gap.to_s;
  };
  return trace.isGap(time_s, time_s) && std::ranges::any_of(trace.log->gaps, isAround);
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

void addRows(const std::vector<double>& times, const std::vector<FlightColumn>& columns,
             Trace& trace) {
  trace.columns = {{"time", "s"}};
  for (const FlightColumn& column : columns) {
    trace.columns.push_back(column.column);
  }
  for (size_t i = 0; i < times.size(); ++i) {
    const double time = times[i] - times[0];
    const bool in_gap = isInGap(trace, time);
    trace.rows.push_back(time);
    for (const FlightColumn& column : columns) {
      trace.rows.push_back(in_gap ? kUnknown : column.values[i]);
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
  std::vector<double> times = recordTimes(merged);
  if (times.empty()) {
    return support::fail(support::diagnostics::noDepthLogged, "no record has a valid time");
  }
  const std::vector<support::TraceGap> gaps = gapsBetween(times, breaksOf(merged.files));
  addBetween(more_times_s, gaps, times);
  Trace trace;
  trace.mission = missionsOf(merged.files);
  trace.state_names = {"surface", "dive", "climb", "hover"};
  trace.log = {.vehicle = merged.files[0].vehicle,
               .utc_s = times[0],
               .beside = "",
               .notes = leftOutOf(merged.files),
               .gaps = gaps};
  std::vector<FlightColumn> columns = {{{"m_depth", "m"}, resampled(depth, times, Between::Line)}};
  if (std::ranges::all_of(columns[0].values, [](double value) { return std::isnan(value); })) {
    return support::fail(support::diagnostics::noDepthLogged,
                         "they do not contain the vehicle's depth");
  }
  std::string note;
  for (auto more : {quantities(merged, times, gaps), positions(merged, times),
                    currents(merged, depth, times, note)}) {
    std::ranges::move(more, std::back_inserter(columns));
  }
  std::erase_if(columns, [](const FlightColumn& column) {
    return std::ranges::all_of(column.values, [](double value) { return std::isnan(value); });
  });
  addRows(times, columns, trace);
  if (!note.empty()) {
    trace.log->notes.push_back(note);
  }
  addEvents(merged, trace);
  return trace;
}

}  // namespace glider::slocum
