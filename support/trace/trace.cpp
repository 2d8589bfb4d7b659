// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/trace.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace glider::support {

using nlohmann::json;

int Trace::column(std::string_view name) const {
  auto found = std::ranges::find(columns, name, &TraceColumn::name);
  return found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
}

std::string traceToCsv(const Trace& trace) {
  std::string out;
  const char* separator = "";
  for (const TraceColumn& column : trace.columns) {
    out += column.unit.empty() ? fmt::format("{}{}", separator, column.name)
                               : fmt::format("{}{} ({})", separator, column.name, column.unit);
    separator = ",";
  }
  out += '\n';
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    for (size_t column = 0; column < trace.columns.size(); ++column) {
      const double value = trace.at(row, static_cast<int>(column));
      out += column == 0 ? "" : ",";
      out += std::isnan(value) ? std::string() : fmt::format("{}", value);
    }
    out += '\n';
  }
  return out;
}

namespace {

json eventsToJson(const std::vector<TraceEvent>& events) {
  json out = json::array();
  for (const TraceEvent& e : events) {
    out.push_back({{"time", e.time_s},
                   {"missionTime", e.mission_time_s},
                   {"kind", e.kind},
                   {"what", e.what},
                   {"why", e.why}});
  }
  return out;
}

}  // namespace

std::string traceToJson(const Trace& trace) {
  json columns = json::array();
  for (const TraceColumn& c : trace.columns) {
    columns.push_back({{"name", c.name}, {"unit", c.unit}});
  }
  const json document = {{"mission", trace.mission},
                         {"scenario", trace.scenario},
                         {"way", trace.way},
                         {"seed", trace.seed},
                         {"states", trace.state_names},
                         {"columns", columns},
                         {"rows", trace.rows},
                         {"events", eventsToJson(trace.events)},
                         {"field",
                          {{"unit", trace.field.unit},
                           {"times", trace.field.times_s},
                           {"depths", trace.field.depths_m},
                           {"values", trace.field.values}}}};
  // Invalid UTF-8 in a name must not abort a flight's report.
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace glider::support
