// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/report/sample_trace.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace glider::report {
namespace {

using support::Trace;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// What the instruments and the mission add to a row at `depth` m and `row`.
std::vector<double> addedTo(double depth, size_t row) {
  const double layer = (depth - 12) / 4;
  const double chlorophyll = 0.4 + 3 * std::exp(-layer * layer);
  const double conductivity = 4.4 - 0.02 * depth;
  const double logged = row % 100 == 50 ? depth : kUnknown;
  return {chlorophyll, conductivity, depth / 10, 0.1, 0.002 * static_cast<double>(row),
          0.05,        -0.02,        logged};
}

void addFacts(Trace& trace) {
  trace.facts.listed = {"m_depth", "sci_flbbcd_chlor_units", "m_roll", "true_lon", "m_depth_state"};
  trace.facts.read = {"m_lat", "m_depth", "sci_flbbcd_chlor_units", "sci_water_temp"};
  trace.facts.logged = {{"log_bloom_at_depth", "bloom, at", "depth"},
                        {"log_turn_here_latitude", "turn", "here latitude", "latitude"},
                        {"log_turn_here_longitude", "turn", "here longitude", "longitude"},
                        {"log_turn_utc", "turn", "utc"}};
  trace.facts.promises = {
      {"require exit within 2 h", support::Verdict::Held, {}, ""},
      {"require always depth < 20 m", support::Verdict::Violated, 600.0, "depth is 21 m"},
      {"require can reach track",
       support::Verdict::NotChecked,
       {},
       "it says what some flight can do"}};
  trace.battery = {1000, 100};
  const int lat = trace.column("true_lat"), lon = trace.column("true_lon");
  trace.facts.places = {{"home", trace.at(0, lat), trace.at(0, lon)}};
  trace.facts.watch_circles = {{trace.at(0, lat), trace.at(0, lon), 150}};
  for (double at = -2000; at <= 2000; at += 500) {
    trace.bottom.x_m.push_back(at);
    trace.bottom.y_m.push_back(at);
  }
  for (const double x : trace.bottom.x_m) {
    for (size_t j = 0; j < trace.bottom.y_m.size(); ++j) {
      trace.bottom.depths_m.push_back(60 + x / 100);
    }
  }
}

}  // namespace

Trace scienceTrace() {
  Trace trace = sampleTrace();
  const size_t width = trace.columns.size();
  const int depth = trace.column("m_depth");
  const auto heading = static_cast<size_t>(trace.column("m_heading"));
  constexpr double kToNorth = 2 * std::numbers::pi - 1.1;  // the sample's heading waves around 1.1
  std::vector<double> rows;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    const auto begin = trace.rows.begin() + static_cast<std::ptrdiff_t>(row * width);
    rows.insert(rows.end(), begin, begin + static_cast<std::ptrdiff_t>(width));
    double& towards = rows[rows.size() - width + heading];
    towards = std::fmod(towards + kToNorth, 2 * std::numbers::pi);
    const std::vector<double> added = addedTo(trace.at(row, depth), row);
    rows.insert(rows.end(), added.begin(), added.end());
    rows.push_back(row % 3 == 0 ? 1 : 2);
    const bool turn = row == 100;  // logged once
    rows.push_back(turn ? trace.at(row, trace.column("true_lat")) : kUnknown);
    rows.push_back(turn ? trace.at(row, trace.column("true_lon")) : kUnknown);
    rows.push_back(turn ? 1250000180 : kUnknown);
  }
  trace.rows = std::move(rows);
  trace.columns.insert(trace.columns.end(), {{"sci_flbbcd_chlor_units", "ug/L"},
                                             {"sci_water_cond", "S/m"},
                                             {"sci_water_pressure", "bar"},
                                             {"m_roll", "rad"},
                                             {"energy", "Wh"},
                                             {"true_current_x", "m/s"},
                                             {"true_current_y", "m/s"},
                                             {"log_bloom_at_depth", "m"},
                                             {"m_depth_state", ""},
                                             {"log_turn_here_latitude", "deg"},
                                             {"log_turn_here_longitude", "deg"},
                                             {"log_turn_utc", "timestamp"}});
  addFacts(trace);
  trace.events.push_back(
      support::makeEvent(2400, support::EventId::Steers, {std::string("ascend"), 5.0}));
  trace.events.push_back(support::unlistedEvent(2410, 2400, "log",
                                                "steers to 39 10.498 N 73 49.821 W",
                                                "distance(home) > watch (lat 39 10.498 N)"));
  return trace;
}

Trace crowdedTrace() {
  Trace trace = longTrace(20'000);
  const int state = trace.column("state");
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    trace.rows[row * trace.columns.size() + static_cast<size_t>(state)] = row / 10 % 2 == 0 ? 0 : 1;
    if (row % 20 == 0) {
      trace.events.push_back(support::makeEvent(trace.at(row, 0), support::EventId::Transition,
                                                {"search", "track", "call"}));
    }
  }
  return trace;
}

}  // namespace glider::report
