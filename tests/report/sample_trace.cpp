// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/report/sample_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace glider::report {

namespace {

using support::Trace;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kCycle = 4;          // s
constexpr double kControlFrom = 260;  // s
constexpr double kControlTo = 1460;   // s
constexpr double kDuration = 2440;    // s
constexpr double kPitch = 0.454;      // rad
constexpr double kDegree = std::numbers::pi / 180;

/// Depth of the middle of the thermocline, m: one internal wave passes.
double thermoclineDepth(double time_s) {
  const double wave = (time_s - 900) / 170;
  return 13.5 + 4.5 * std::exp(-wave * wave) - 0.8 * std::sin(time_s / 420);
}

double temperature(double time_s, double depth_m) {
  return 15.5 - 8.5 * std::tanh((depth_m - thermoclineDepth(time_s)) / 2.4);
}

struct Flown {
  double time = 0, depth = 1.2, pitch = 0, heading = 1.1, x = 0, y = 0, x_dr = 0, y_dr = 0;
  bool down = true;
  bool control = false;
  int state = -1;  // 0 search, 1 track
  double top = 3, bottom = 28;
};

/// One row: name, unit and value of every column.
struct Cell {
  const char* name;
  const char* unit;
  double value;
};

double waver(double time_s, double period_s) {
  return std::sin(2 * std::numbers::pi * time_s / period_s);
}

std::vector<Cell> cells(const Flown& g) {
  const double inside = g.control ? 1 : kNaN;
  const double commanded_pitch = g.down ? -kPitch : kPitch;
  const double pump = g.down ? -210 : 210;
  const double lat = 39.175 + g.y / 111000;
  const double lon = -73.83 + g.x / 86400;
  return {
      {"time", "s", g.time},
      {"missiontime", "s", inside * (g.time - kControlFrom)},
      {"state", "id", g.state < 0 ? kNaN : g.state},
      {"m_depth", "m", g.depth + 0.04 * waver(g.time, 11)},
      {"true_depth", "m", g.depth},
      {"m_depth_rate", "m/s", 0.17 * std::sin(-g.pitch) / std::sin(kPitch)},
      {"m_pitch", "rad", g.pitch + 0.012 * waver(g.time, 26)},
      {"c_pitch", "rad", commanded_pitch},
      {"m_heading", "rad", g.heading + 0.05 * waver(g.time, 90)},
      {"c_heading", "rad", g.control ? kNaN : 1.1},
      {"m_lat", "deg", 39.175 + g.y_dr / 111000},
      {"m_lon", "deg", -73.83 + g.x_dr / 86400},
      {"true_lat", "deg", lat},
      {"true_lon", "deg", lon},
      {"m_x_lmc", "m", g.x_dr},
      {"m_y_lmc", "m", g.y_dr},
      {"true_x", "m", g.x},
      {"true_y", "m", g.y},
      {"c_wpt_x_lmc", "m", 4200},
      {"c_wpt_y_lmc", "m", 2100},
      {"sci_water_temp", "degC", temperature(g.time, g.depth) + 0.02 * waver(g.time, 7)},
      {"m_ballast_pumped", "cc", pump * std::sin(std::abs(g.pitch)) / std::sin(kPitch)},
      {"c_ballast_pumped", "cc", pump},
      {"m_battery", "V", 14.8 - 0.00006 * g.time - (std::abs(g.pitch) < 0.4 ? 0.12 : 0.0)},
      {"hook_active", "", g.control ? 1.0 : 0.0},
      {"hook_vertical", "", g.control ? (g.down ? 1.0 : 2.0) : 0.0},
      {"hook_depth", "m", inside * (g.down ? g.bottom : g.top)},
      {"commanded_top", "m", inside * g.top},
      {"commanded_bottom", "m", inside * g.bottom},
      {"isotherm_depth", "m", thermoclineDepth(g.time)},
      {"water_depth", "m", 31.5 + 0.8 * waver(g.time, 1900)},
      {"layer", "", g.control ? 3.0 : 4.0},
  };
}

class Sample {
 public:
  Trace make() {
    trace_.mission = "thermoclineSurvey";
    trace_.scenario = "shelf-summer";
    trace_.way = "in-process";
    trace_.seed = 7;
    trace_.state_names = {"search", "track"};
    event(0, "hook", "hookprog and SBC shook hands", "protocol 1, dictionary 5f1c22a0");
    for (glider_.time = 0; glider_.time <= kDuration; glider_.time += kCycle) {
      decide();
      record();
      move();
    }
    fillField();
    return std::move(trace_);
  }

 private:
  void event(double time, std::string kind, std::string what, std::string why) {
    const double mission_time = glider_.control ? time - kControlFrom : kNaN;
    trace_.events.push_back(support::unlistedEvent(time, mission_time, std::move(kind),
                                                   std::move(what), std::move(why)));
  }

  void decide() {
    Flown& g = glider_;
    if (!g.control && g.time >= kControlFrom && g.time < kControlTo) {
      g.control = true;
      g.state = 0;
      event(g.time, "control", "hookbeh in control", "b_arg start_after = 260 s");
      event(g.time, "transition", "→ search (start)", "mission start");
    }
    if (g.state == 0 && g.depth > thermoclineDepth(g.time) + 5 && g.time > kControlFrom + 20) {
      g.state = 1;
      event(g.time, "transition", "search → track (call)",
            "became(spread(temp, 10 m of depth) >= 6 degC): temp = 7.3 degC, depth = 19.2 m");
    }
    if (g.control && g.time >= kControlTo) {
      event(g.time, "transition", "track → exit", "missiontime >= 1200: missiontime = 1200 s");
      event(g.time, "control", "released to layered control", "the mission has ended");
      g.control = false;
      g.state = -1;
    }
    steerVertically();
  }

  void steerVertically() {
    Flown& g = glider_;
    if (g.state == 1) {
      g.top = std::max(3.0, held_ - 5);
      g.bottom = held_ + 5;
    } else {
      g.top = 3;
      g.bottom = 28;
    }
    if (g.down && g.depth >= g.bottom) {
      turn(false);
    } else if (!g.down && g.depth <= g.top) {
      turn(true);
    }
  }

  void turn(bool down) {
    Flown& g = glider_;
    g.down = down;
    held_ = thermoclineDepth(g.time);
    const char* what = down ? "dive_to" : "climb_to";
    if (g.control) {
      event(g.time, "hook", fmt::format("{} {:.1f} m", what, down ? g.bottom : g.top),
            fmt::format("sequence {}, echoed", ++sequence_));
    } else {
      event(g.time, "behaviour", fmt::format("yo: {}", what), "target depth reached");
    }
  }

  void record() {
    const std::vector<Cell> row = cells(glider_);
    if (trace_.columns.empty()) {
      for (const Cell& cell : row) {
        trace_.columns.push_back({cell.name, cell.unit});
      }
    }
    for (const Cell& cell : row) {
      trace_.rows.push_back(cell.value);
    }
  }

  void move() {
    Flown& g = glider_;
    const double commanded = g.down ? -kPitch : kPitch;
    g.pitch += (commanded - g.pitch) * (1 - std::exp(-kCycle / 9));
    g.depth = std::max(0.0, g.depth - 0.17 * kCycle * std::sin(g.pitch) / std::sin(kPitch));
    const double speed = 0.31 * std::cos(g.pitch);
    g.heading = g.control ? 1.1 + 0.6 * std::sin((g.time - kControlFrom) / 500) : 1.1;
    g.x_dr += kCycle * speed * std::sin(g.heading);
    g.y_dr += kCycle * speed * std::cos(g.heading);
    g.x += kCycle * (speed * std::sin(g.heading) + 0.03);
    g.y += kCycle * (speed * std::cos(g.heading) - 0.045);
  }

  void fillField() {
    for (double time = 0; time <= kDuration; time += 20) {
      trace_.field.times_s.push_back(time);
    }
    for (double depth = 0; depth <= 36; depth += 0.5) {
      trace_.field.depths_m.push_back(depth);
    }
    for (const double time : trace_.field.times_s) {
      for (const double depth : trace_.field.depths_m) {
        trace_.field.values.push_back(temperature(time, depth));
      }
    }
  }

  Trace trace_;
  Flown glider_;
  double held_ = 13;
  int sequence_ = 0;
};

}  // namespace

Trace sampleTrace() {
  return Sample().make();
}

Trace longTrace(size_t rows) {
  Trace trace = sampleTrace();
  const size_t width = trace.columns.size();
  const std::vector<double> once = trace.rows;
  const auto time = static_cast<size_t>(trace.column("time"));
  for (size_t lap = 1; trace.rowCount() < rows; ++lap) {
    for (size_t i = 0; i < once.size() && trace.rowCount() < rows; i += width) {
      const auto from = once.begin() + static_cast<std::ptrdiff_t>(i);
      trace.rows.insert(trace.rows.end(), from, from + static_cast<std::ptrdiff_t>(width));
      trace.rows[trace.rows.size() - width + time] +=
          static_cast<double>(lap) * (kDuration + kCycle);
    }
  }
  return trace;
}

namespace {

/// What becomes of a column of the sample in the log of a vehicle.
struct Logged {
  const char* from;
  support::TraceColumn to;
};

const Logged kLogged[] = {
    {"m_x_lmc", {"dr_x", "m"}},
    {"m_y_lmc", {"dr_y", "m"}},
    {"true_depth", {"sim_depth", "m"}},
    {"true_x", {"sim_x", "m"}},
    {"true_y", {"sim_y", "m"}},
    {"true_lat", {"m_gps_lat", "deg"}},
    {"true_lon", {"m_gps_lon", "deg"}},
    {"c_wpt_x_lmc", {"current_x", "m/s"}},
    {"c_wpt_y_lmc", {"current_y", "m/s"}},
    {"hook_active", {"m_leak", ""}},
    {"hook_vertical", {"dr_leg", ""}},
    {"hook_depth", {"power", "W"}},
    {"commanded_top", {"energy", "Wh"}},
    {"commanded_bottom", {"gps_x", "m"}},
    {"isotherm_depth", {"gps_y", "m"}},
    {"layer", {"cc_final_heading_mode", ""}},
};

/// The columns that only a log has, at a row: a fix moves the position in the middle, where a
/// current is estimated; before that nothing was logged for a while.
void fillLogged(Trace& trace, size_t row, size_t middle) {
  const auto set = [&](const char* name, double value) {
    trace.rows[row * trace.columns.size() + static_cast<size_t>(trace.column(name))] = value;
  };
  const bool later = row >= middle;
  const bool fix = row == 0 || row == middle;
  set("state", static_cast<double>(row / 40 % 3));
  set("current_x", later ? 0.2 : 0.1);
  set("current_y", later ? -0.1 : 0.1);
  set("dr_leg", later ? 1 : 0);
  set("dr_x", trace.at(row, trace.column("dr_x")) + (later ? 200 : 0));
  for (const char* name : {"m_gps_lat", "m_gps_lon"}) {
    set(name, fix ? trace.at(row, trace.column(name)) : kNaN);
  }
  set("gps_x", fix ? trace.at(row, trace.column("dr_x")) : kNaN);
  set("gps_y", fix ? trace.at(row, trace.column("dr_y")) : kNaN);
  set("power", 2);
  set("energy", static_cast<double>(row) * 0.01);
  set("cc_final_heading_mode", 0);
  if (row > middle - 40 && row < middle - 20) {
    set("m_depth", kNaN);
    set("water_depth", kNaN);
  }
}

}  // namespace

Trace logTrace() {
  Trace trace = sampleTrace();
  trace.mission = "SPIRAL.MI";
  trace.scenario = "";
  trace.way = "";
  trace.state_names = {"surface", "dive", "climb", "hover"};
  trace.field = {};
  trace.log = support::VehicleLog{"comet", 1565364272, "flight/trace.csv", {"a note"}};
  for (const Logged& logged : kLogged) {
    trace.columns[static_cast<size_t>(trace.column(logged.from))] = logged.to;
  }
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    fillLogged(trace, row, trace.rowCount() / 2);
  }
  trace.events = {support::unlistedEvent(120, 1000, "dive", "left the surface", ""),
                  support::unlistedEvent(1220, 2100, "surface", "at the surface", ""),
                  support::unlistedEvent(1300, 2180, "abort", "too deep", "mission status 7")};
  return trace;
}

Trace hostileTrace() {
  Trace trace = sampleTrace();
  const std::string script = "</script><script>window.glider_was_here = 1</script>";
  const std::string image = "<img src=x onerror=\"window.glider_was_here = 1\">";
  trace.mission = script + "</title><!-- ünïcødé 海洋 \xE2\x80\xA8 \x1b[31m \xff";
  trace.scenario = image;
  trace.way = "constructor";
  trace.state_names = {script, image};
  trace.columns.back().name = script;
  trace.columns.back().unit = "__proto__";
  trace.field.unit = image;
  for (support::TraceEvent& event : trace.events) {
    event = support::unlistedEvent(event.time_s, event.mission_time_s, kindOf(event),
                                   textOf(event) + script, event.why + image);
  }
  trace.events.push_back(support::unlistedEvent(kNaN, kNaN, "__proto__", image, "<!--<script>"));
  return trace;
}

Trace bareTrace() {
  Trace trace = sampleTrace();
  trace.field = {};
  trace.events.clear();
  trace.state_names.clear();
  const auto depth = static_cast<size_t>(trace.column("m_depth"));
  const auto state = static_cast<size_t>(trace.column("state"));
  const auto width = trace.columns.size();
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    trace.rows[row * width + state] = kNaN;
    if (row > 200 && row < 260) {
      trace.rows[row * width + depth] = kNaN;
    }
  }
  return trace;
}

}  // namespace glider::report
