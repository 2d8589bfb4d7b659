// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/trace.h"

#include "support/diagnostics/ids/flights.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace glider::support {

using nlohmann::json;

int Trace::column(std::string_view name) const {
  auto found = std::ranges::find(columns, name, &TraceColumn::name);
  return found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
}

bool Trace::isGap(double from_s, double to_s) const {
  if (!log) {
    return false;
  }
  const auto after = std::ranges::upper_bound(log->gaps, from_s, {}, &TraceGap::from_s);
  return after != log->gaps.begin() && to_s <= std::prev(after)->to_s;
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

json gapsToJson(const std::vector<TraceGap>& gaps) {
  json out = json::array();
  for (const TraceGap& gap : gaps) {
    out.push_back({gap.from_s, gap.to_s});
  }
  return out;
}

json eventsToJson(const std::vector<TraceEvent>& events) {
  json out = json::array();
  for (const TraceEvent& e : events) {
    out.push_back({{"time", e.time_s},
                   {"missionTime", e.mission_time_s},
                   {"kind", kindOf(e)},
                   {"what", shownTextOf(e)},
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
  json document = {{"mission", trace.mission},
                   {"scenario", trace.scenario},
                   {"way", trace.way},
                   {"seed", trace.seed},
                   {"ownControl", trace.own_control},
                   {"states", trace.state_names},
                   {"columns", columns},
                   {"rows", trace.rows},
                   {"events", eventsToJson(trace.events)},
                   {"field",
                    {{"unit", trace.field.unit},
                     {"times", trace.field.times_s},
                     {"depths", trace.field.depths_m},
                     {"values", trace.field.values}}}};
  if (trace.log) {
    document["log"] = {{"vehicle", trace.log->vehicle},
                       {"utc", trace.log->utc_s},
                       {"beside", trace.log->beside},
                       {"gaps", gapsToJson(trace.log->gaps)}};
  }
  if (trace.requirement) {
    document["settings"] = trace.settings;
    document["requirement"] = *trace.requirement;
  }
  // Invalid UTF-8 in a name must not abort a flight's report.
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

namespace {

double numberOrNaN(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

void readEvents(const json& document, Trace& trace) {
  for (const json& one : document.at("events")) {
    trace.events.push_back(
        unlistedEvent(one.at("time").get<double>(), numberOrNaN(one.at("missionTime")),
                      one.at("kind").get<std::string>(), one.at("what").get<std::string>(),
                      one.at("why").get<std::string>()));
  }
}

Trace readDocument(const json& document) {
  Trace trace;
  document.at("mission").get_to(trace.mission);
  document.at("scenario").get_to(trace.scenario);
  document.at("way").get_to(trace.way);
  document.at("seed").get_to(trace.seed);
  trace.own_control = document.value("ownControl", trace.own_control);  // an older trace has none
  document.at("states").get_to(trace.state_names);
  for (const json& column : document.at("columns")) {
    trace.columns.push_back(
        {column.at("name").get<std::string>(), column.at("unit").get<std::string>()});
  }
  for (const json& value : document.at("rows")) {
    trace.rows.push_back(numberOrNaN(value));
  }
  readEvents(document, trace);
  if (document.contains("requirement")) {
    document.at("settings").get_to(trace.settings);
    trace.requirement = document.at("requirement").get<uint32_t>();
  }
  return trace;
}

}  // namespace

Result<Trace> traceFromJson(const std::string& text, const std::string& name) {
  try {
    Trace trace = readDocument(json::parse(text));
    if (trace.columns.empty() || trace.rows.size() % trace.columns.size() != 0) {
      return fail(support::diagnostics::noTrace, name, "its rows do not fit its columns");
    }
    return trace;
  } catch (const json::exception& trouble) {
    return fail(support::diagnostics::noTrace, name, trouble.what());
  }
}

}  // namespace glider::support
