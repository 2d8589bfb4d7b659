// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/figures.h"

#include "support/trace/submersions.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::report {

namespace {

using support::Trace;

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

struct Range {
  double least = kNoFigure;
  double greatest = kNoFigure;
};

Range rangeOf(const Trace& trace, int column) {
  Range range;
  for (size_t row = 0; column >= 0 && row < trace.rowCount(); ++row) {
    // fmin and fmax ignore NaN.
    range.least = std::fmin(range.least, trace.at(row, column));
    range.greatest = std::fmax(range.greatest, trace.at(row, column));
  }
  return range;
}

/// A track without the steps by which GPS fixes have moved it: they are not distance covered, and
/// the ends of what remains can be compared.
class Way {
 public:
  /// `leg` changes where a fix has moved the position.
  void add(double x, double y, double leg) {
    if (!begun_ || leg != leg_) {
      closeLeg();
      leg_x_ = x, leg_y_ = y, leg_ = leg;
      begun_ = true;
    } else {
      sum_ += std::hypot(x - x_, y - y_);
    }
    x_ = x, y_ = y;
  }
  void measure(FlightFigures& figures) {
    if (begun_) {
      closeLeg();
      figures.distance_m = sum_;
      figures.made_good_m = std::hypot(way_x_, way_y_);
    }
  }

 private:
  void closeLeg() {
    way_x_ += x_ - leg_x_;
    way_y_ += y_ - leg_y_;
  }

  bool begun_ = false;
  double leg_ = 0, leg_x_ = 0, leg_y_ = 0;  ///< where the leg begins
  double x_ = 0, y_ = 0;                    ///< the last position
  double way_x_ = 0, way_y_ = 0, sum_ = 0;  ///< of the legs before; along the track
};

/// `leg`: a column that changes where a GPS fix moved the position; or -1.
void measureTrack(const Trace& trace, int east, int north, int leg, FlightFigures& figures) {
  Way way;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    const double x = trace.at(row, east), y = trace.at(row, north);
    if (std::isfinite(x) && std::isfinite(y)) {
      way.add(x, y, leg < 0 ? 0 : trace.at(row, leg));
    }
  }
  way.measure(figures);
}

void measureTrack(const Trace& trace, FlightFigures& figures) {
  figures.distance_m = kNoFigure;
  figures.made_good_m = kNoFigure;
  const struct {
    TrackSource source;
    int east;
    int north;
  } candidates[] = {
      {TrackSource::True, trace.column("true_x"), trace.column("true_y")},
      {TrackSource::DeadReckoned, trace.column("m_x_lmc"), trace.column("m_y_lmc")},
      {TrackSource::DeadReckoned, trace.column("dr_x"), trace.column("dr_y")},
  };
  for (const auto& candidate : candidates) {
    if (candidate.east >= 0 && candidate.north >= 0 && std::isnan(figures.distance_m)) {
      measureTrack(trace, candidate.east, candidate.north, trace.column("dr_leg"), figures);
      figures.track = std::isnan(figures.distance_m) ? TrackSource::None : candidate.source;
    }
  }
}

void measureStates(const Trace& trace, int time, FlightFigures& figures) {
  const int state = trace.column("state");
  const int active = trace.column("hook_active");
  if (time < 0 || (state < 0 && active < 0)) {
    figures.layered_s = kNoFigure;
    figures.stateless_s = kNoFigure;
    return;
  }
  std::map<double, StateFigures> by_id;
  double before = kNoFigure;
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    const double id = state < 0 ? kNoFigure : trace.at(row, state);
    const bool last = row + 1 == trace.rowCount();
    const double now = trace.at(row, time), next = last ? now : trace.at(row + 1, time);
    const double held_s = std::isnan(next - now) || trace.isGap(now, next) ? 0.0 : next - now;
    if (!std::isnan(id)) {
      StateFigures& entry = by_id[id];
      entry.stretches += id == before ? 0 : 1;
      entry.time_s += held_s;
    } else if (active >= 0 && trace.at(row, active) > 0) {
      figures.stateless_s += held_s;
    } else {
      figures.layered_s += held_s;
    }
    before = id;
  }
  for (auto& [id, entry] : by_id) {
    entry.id = id;
    entry.name = stateName(trace, id);
    figures.states.push_back(std::move(entry));
  }
}

double greatestDistance(const Trace& trace) {
  const int x = trace.column("true_x"), y = trace.column("true_y");
  const int reckoned_x = trace.column("m_x_lmc"), reckoned_y = trace.column("m_y_lmc");
  double greatest = kNoFigure;
  for (size_t row = 0;
       row < trace.rowCount() && x >= 0 && y >= 0 && reckoned_x >= 0 && reckoned_y >= 0; ++row) {
    greatest = std::fmax(greatest, std::hypot(trace.at(row, x) - trace.at(row, reckoned_x),
                                              trace.at(row, y) - trace.at(row, reckoned_y)));
  }
  return greatest;
}

/// How long `column` was known.
double knownFor(const Trace& trace, int column, int time) {
  double sum_s = 0;
  for (size_t row = 1; column >= 0 && time >= 0 && row < trace.rowCount(); ++row) {
    const double before = trace.at(row - 1, time), now = trace.at(row, time);
    const bool known = !std::isnan(trace.at(row - 1, column)) && !std::isnan(trace.at(row, column));
    sum_s += known && !trace.isGap(before, now) ? now - before : 0;
  }
  return sum_s;
}

}  // namespace

double EnergyFigures::atMost_Wh() const {
  double sum_Wh = 0;
  for (const support::Consumer& one : at_most) {
    sum_Wh += one.used_Wh;
  }
  return at_most.empty() ? kNoFigure : sum_Wh;
}

namespace {

EnergyFigures energyOf(const Trace& trace, double duration_s) {
  constexpr double kSecondsPerDay = 86400;
  constexpr double kWhole = 0.95;  // records begin and end a little later than others
  const int column = trace.column("energy");
  const double known_s = knownFor(trace, column, trace.column("time"));
  EnergyFigures energy{.used_Wh = rangeOf(trace, column).greatest,
                       .known_s = known_s,
                       .partly_known = known_s < kWhole * duration_s,
                       .capacity_Wh = kNoFigure,
                       .to_go_Wh = kNoFigure,
                       .days_left = kNoFigure,
                       .at_most = trace.facts.at_most};
  if (trace.battery) {
    energy.consumers = trace.battery->consumers;
    std::ranges::stable_sort(energy.consumers, std::ranges::greater(), &support::Consumer::used_Wh);
    energy.capacity_Wh = trace.battery->capacity_Wh;
    energy.to_go_Wh = energy.capacity_Wh - trace.battery->used_Wh - energy.used_Wh;
    energy.days_left = energy.used_Wh > 0
                           ? energy.to_go_Wh / energy.used_Wh * energy.known_s / kSecondsPerDay
                           : kNoFigure;
  }
  return energy;
}

double lengthOfGaps(const Trace& trace) {
  double sum_s = 0;
  for (const support::TraceGap& gap :
       trace.log ? trace.log->gaps : std::vector<support::TraceGap>()) {
    sum_s += gap.to_s - gap.from_s;
  }
  return sum_s;
}

/// The last row in which `column` is known; 0 if there is none.
size_t lastKnown(const Trace& trace, int column) {
  size_t row = trace.rowCount();
  while (row > 1 && std::isnan(trace.at(row - 1, column))) {
    --row;
  }
  return row == 0 ? 0 : row - 1;
}

const char* trackSourceName(TrackSource source) {
  switch (source) {
    case TrackSource::True:
      return "true";
    case TrackSource::DeadReckoned:
      return "dead-reckoned";
    case TrackSource::None:
      break;
  }
  return "none";
}

}  // namespace

std::vector<TurningPoint> turningPoints(const Trace& trace) {
  const int depth = depthColumn(trace);
  std::vector<TurningPoint> points;
  bool diving = false;
  double extreme = kNoFigure;  // the shallowest depth of this climb, or the deepest of this dive
  size_t extreme_row = 0;
  for (size_t row = 0; depth >= 0 && row < trace.rowCount(); ++row) {
    const double here = trace.at(row, depth);
    if (std::isnan(here)) {
      continue;
    }
    const bool further = diving ? here >= extreme : here <= extreme;
    if (further || std::isnan(extreme)) {
      extreme = here;
      extreme_row = row;
    } else if (std::abs(here - extreme) >= kYoDepth) {
      points.push_back({extreme_row, diving});
      diving = !diving;
      extreme = here;
      extreme_row = row;
    }
  }
  return points;
}

namespace {

/// The mean rate between the bottom of a yo and its end, m/s: up to where the vehicle first is at
/// the surface from there, if it is. What it waits there is no part of the climb, or of the dive.
double rateBetween(const Trace& trace, size_t bottom, size_t end) {
  const int depth = depthColumn(trace), time = trace.column("time");
  size_t row = bottom;
  while (row != end && !(trace.at(row, depth) < support::kSurfaceDepth)) {
    row = end > bottom ? row + 1 : row - 1;
  }
  return (trace.at(bottom, depth) - trace.at(row, depth)) /
         std::abs(trace.at(row, time) - trace.at(bottom, time));
}

/// Whether a hover was in force at the bottom and at the next top: not a yo, but how it keeps to
/// the depth.
bool isSwing(const Trace& trace, const std::vector<TurningPoint>& turns, size_t bottom) {
  const int vertical = trace.column("hook_vertical");
  const auto hovers = [&](size_t row) {
    return trace.at(row, vertical) == support::kHoverCommanded;
  };
  return vertical >= 0 && bottom + 1 < turns.size() && hovers(turns[bottom].row) &&
         hovers(turns[bottom + 1].row);
}

}  // namespace

std::vector<Yo> yosOf(const Trace& trace) {
  const int depth = depthColumn(trace), time = trace.column("time");
  const std::vector<TurningPoint> turns = turningPoints(trace);
  std::vector<Yo> yos;
  for (size_t i = 0; time >= 0 && i < turns.size(); ++i) {
    if (!turns[i].at_bottom || isSwing(trace, turns, i)) {
      continue;
    }
    const size_t bottom = turns[i].row;
    const size_t begin = i == 0 ? 0 : turns[i - 1].row;
    const size_t end = i + 1 < turns.size() ? turns[i + 1].row : lastKnown(trace, depth);
    yos.push_back({.start_s = trace.at(begin, time),
                   .duration_s = trace.at(end, time) - trace.at(begin, time),
                   .deepest_m = trace.at(bottom, depth),
                   .down_mps = rateBetween(trace, bottom, begin),
                   .up_mps = rateBetween(trace, bottom, end),
                   .surfaced = trace.at(end, depth) < support::kSurfaceDepth});
  }
  return yos;
}

std::string yosToJson(const std::vector<Yo>& yos) {
  nlohmann::json out = nlohmann::json::array();
  for (const Yo& yo : yos) {
    out.push_back({{"start", yo.start_s},
                   {"duration", yo.duration_s},
                   {"deepest", yo.deepest_m},
                   {"down", yo.down_mps},
                   {"up", yo.up_mps},
                   {"surfaced", yo.surfaced}});
  }
  return out.dump();
}

int depthColumn(const Trace& trace) {
  const int measured = trace.column("m_depth");
  return measured >= 0 ? measured : trace.column("true_depth");
}

std::string flightTitle(const Trace& trace) {
  return trace.log ? trace.log->vehicle + ": " + trace.mission : trace.mission;
}

std::string stateName(const Trace& trace, double id) {
  if (id >= 0 && id < static_cast<double>(trace.state_names.size()) && std::floor(id) == id) {
    return trace.state_names[static_cast<size_t>(id)];
  }
  return fmt::format("state {}", id);
}

namespace {

/// From each time that the SBC sleeps until it is woken.
void measureSleep(const Trace& trace, FlightFigures& figures) {
  double since_s = kNoFigure;
  figures.sleep_saves = !trace.battery || trace.battery->sleep_saves;
  for (const support::TraceEvent& event : trace.events) {
    if (event.id == support::EventId::SbcSleeps) {
      since_s = event.time_s;
      ++figures.sleeps;
    } else if (event.id == support::EventId::SbcWoken && std::isfinite(since_s)) {
      figures.asleep_s += event.time_s - since_s;
      since_s = kNoFigure;
    }
  }
}

}  // namespace

FlightFigures flightFigures(const Trace& trace) {
  FlightFigures figures;
  figures.rows = trace.rowCount();
  const int time = trace.column("time");
  const Range times = rangeOf(trace, time);
  figures.duration_s = times.greatest - times.least;
  // The true depth, which a faulty sensor must not hide.
  const int truth = trace.column("true_depth");
  const Range depths = rangeOf(trace, truth >= 0 ? truth : depthColumn(trace));
  figures.shallowest_m = depths.least;
  figures.deepest_m = depths.greatest;
  const auto turns = turningPoints(trace);
  for (size_t i = 0; i < turns.size(); ++i) {
    if (turns[i].at_bottom) {
      ++(isSwing(trace, turns, i) ? figures.swings : figures.yos);
    }
  }
  const Range temperatures = rangeOf(trace, trace.column("sci_water_temp"));
  figures.coldest_degC = temperatures.least;
  figures.warmest_degC = temperatures.greatest;
  figures.gaps_s = lengthOfGaps(trace);
  measureTrack(trace, figures);
  figures.apart_m = greatestDistance(trace);
  figures.energy = energyOf(trace, figures.duration_s);
  measureStates(trace, time, figures);
  measureSleep(trace, figures);
  for (const support::TraceEvent& event : trace.events) {
    ++figures.events[kindOf(event)];
  }
  return figures;
}

namespace {

nlohmann::json consumersToJson(const EnergyFigures& energy) {
  nlohmann::json list = nlohmann::json::array();
  for (const support::Consumer& one : energy.consumers) {
    list.push_back({{"device", one.device}, {"used", one.used_Wh}});
  }
  return list;
}

}  // namespace

std::string figuresToJson(const FlightFigures& figures) {
  using nlohmann::json;
  json states = json::array();
  for (const StateFigures& state : figures.states) {
    states.push_back({{"id", state.id},
                      {"name", state.name},
                      {"stretches", state.stretches},
                      {"time", state.time_s}});
  }
  const json out = {{"rows", figures.rows},
                    {"duration", figures.duration_s},
                    {"gaps", figures.gaps_s},
                    {"shallowest", figures.shallowest_m},
                    {"deepest", figures.deepest_m},
                    {"yos", figures.yos},
                    {"surfaceDepth", support::kSurfaceDepth},
                    {"distance", figures.distance_m},
                    {"madeGood", figures.made_good_m},
                    {"track", trackSourceName(figures.track)},
                    {"apart", figures.apart_m},
                    {"energy",
                     {{"used", figures.energy.used_Wh},
                      {"known", figures.energy.known_s},
                      {"partlyKnown", figures.energy.partly_known},
                      {"capacity", figures.energy.capacity_Wh},
                      {"toGo", figures.energy.to_go_Wh},
                      {"daysLeft", figures.energy.days_left},
                      {"atMost", figures.energy.atMost_Wh()},
                      {"consumers", consumersToJson(figures.energy)}}},
                    {"coldest", figures.coldest_degC},
                    {"warmest", figures.warmest_degC},
                    {"states", states},
                    {"layered", figures.layered_s},
                    {"stateless", figures.stateless_s}};
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace glider::report
