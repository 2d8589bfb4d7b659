// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/recorder.h"

#include "simulator/flight/position.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace glider::simulator {
namespace {

constexpr double kNotRecorded = std::numeric_limits<double>::quiet_NaN();

}  // namespace

/// The sources of a row.
struct RecorderMoment {
  double now_s;
  const FlightController& flight;
  const ScienceComputer& science;
  const Vehicle& vehicle;
  GeoPosition truth;
  double isotherm_m, water_depth_m;

  [[nodiscard]] double get(Sensor sensor) const { return flight.array().get(sensor); }
};

namespace {

struct Column {
  const char* name;
  const char* unit;
  double (*value)(const RecorderMoment& m);
  /// Whether a scenario needs the column; null: every scenario does.
  bool (*wanted)(const Scenario& s) = nullptr;
};

/// True if the scenario specifies a sloping bottom, seamounts or an altimeter.
bool wantsAltitude(const Scenario& s) {
  const BottomSettings& bottom = s.ocean.bottom;
  return bottom.slope != 0 || !bottom.seamounts.empty() || s.sensors.altimeter.given;
}

// missiontime and state are filled in by Recorder::mission.
#define COLUMN(name, unit, value, ...)                                                   \
  {name, unit, []([[maybe_unused]] const RecorderMoment& m) -> double { return value; }, \
   __VA_ARGS__}
constexpr Column kFirst[] = {
    COLUMN("time", "s", m.now_s),
    COLUMN("missiontime", "s", kNotRecorded),
    COLUMN("state", "id", kNotRecorded),
    COLUMN("m_depth", "m", m.get(Sensor::m_depth)),
    COLUMN("true_depth", "m", m.vehicle.depth()),
    COLUMN("m_pitch", "rad", m.get(Sensor::m_pitch)),
    COLUMN("c_pitch", "rad", m.get(Sensor::c_pitch)),
    COLUMN("m_heading", "rad", m.get(Sensor::m_heading)),
    COLUMN("c_heading", "rad", m.get(Sensor::c_heading)),
    COLUMN("m_lat", "deg", fromDdmm(m.get(Sensor::m_lat))),
    COLUMN("m_lon", "deg", fromDdmm(m.get(Sensor::m_lon))),
    COLUMN("true_lat", "deg", m.truth.latitude_deg),
    COLUMN("true_lon", "deg", m.truth.longitude_deg),
    COLUMN("m_x_lmc", "m", m.flight.reckoned().east),
    COLUMN("m_y_lmc", "m", m.flight.reckoned().north),
    COLUMN("true_x", "m", m.vehicle.x()),
    COLUMN("true_y", "m", m.vehicle.y()),
};
// The columns of instruments that every vehicle has are between these two lists, those of the
// others after both.
constexpr Column kSecond[] = {
    COLUMN("m_ballast_pumped", "cc", m.get(Sensor::m_ballast_pumped)),
    COLUMN("c_ballast_pumped", "cc", m.get(Sensor::c_ballast_pumped)),
    COLUMN("m_battery", "V", m.get(Sensor::m_battery)),
    COLUMN("m_depth_rate", "m/s", m.get(Sensor::m_depth_rate)),
    COLUMN("hook_active", "", m.flight.hookActive() ? 1 : 0),
    COLUMN("hook_vertical", "", m.flight.obeyed().vertical),
    COLUMN("hook_depth", "m", m.flight.obeyed().depth_m),
    COLUMN("commanded_top", "m", m.flight.obeyed().top_m),
    COLUMN("commanded_bottom", "m", m.flight.obeyed().bottom_m),
    COLUMN("isotherm_depth", "m", m.isotherm_m),
    COLUMN("water_depth", "m", m.water_depth_m),
    COLUMN("c_wpt_lat", "deg", fromDdmm(m.flight.waypointLatitude())),
    COLUMN("c_wpt_lon", "deg", fromDdmm(m.flight.waypointLongitude())),
    COLUMN("layer", "", m.flight.layer() == kNoLayer ? kNotRecorded : m.flight.layer()),
    // NaN in a cycle without an echo.
    COLUMN("m_altitude", "m",
           m.flight.array().fresh(Sensor::m_altitude) ? m.get(Sensor::m_altitude) : kNotRecorded,
           wantsAltitude),
    COLUMN("m_water_vx", "m/s", m.flight.waterVelocity().east),
    COLUMN("m_water_vy", "m/s", m.flight.waterVelocity().north),
};
#undef COLUMN

constexpr size_t kMissionTimeColumn = 1, kStateColumn = 2;
constexpr size_t kMostTimes = 400, kDepths = 80;

}  // namespace

Recorder::Recorder(support::Trace& trace, const Ocean& ocean, const LocalFrame& frame,
                   const platforms::Platform& platform, const Scenario& scenario)
    : trace_(trace), ocean_(ocean), frame_(frame), isotherm_(scenario.isotherm_degC) {
  const auto add = [&](std::span<const Column> columns) {
    for (const Column& column : columns) {
      if (column.wanted == nullptr || column.wanted(scenario)) {
        columns_.push_back({column.value});
        trace_.columns.push_back({column.name, column.unit});
      }
    }
  };
  add(kFirst);
  addInstruments(platform, scenario, true);
  add(kSecond);
  addInstruments(platform, scenario, false);
}

void Recorder::addInstruments(const platforms::Platform& platform, const Scenario& scenario,
                              bool of_each_vehicle) {
  for (const std::unique_ptr<Instrument>& instrument : makeInstruments(0, scenario.sensors)) {
    if (!instrument->carried() || instrument->setting().empty() != of_each_vehicle) {
      continue;
    }
    for (const InstrumentSensor& sensor : instrument->sensors()) {
      if (sensor.column_unit != nullptr) {
        columns_.push_back({nullptr, numberOf(platform, sensor.name)});
        trace_.columns.push_back({std::string(sensor.name), sensor.column_unit});
      }
    }
  }
}

void Recorder::row(double now_s, const FlightController& flight, const ScienceComputer& science,
                   const Vehicle& vehicle) {
  const double x = vehicle.x(), y = vehicle.y();
  const double isotherm =
      std::isnan(isotherm_) ? kNotRecorded : ocean_.isothermDepth(isotherm_, x, y, now_s);
  const RecorderMoment moment{
      now_s, flight, science, vehicle, frame_.position(x, y), isotherm, ocean_.waterDepth(x, y)};
  for (const RecorderColumn& column : columns_) {
    trace_.rows.push_back(column.value != nullptr ? column.value(moment)
                                                  : science.recorded(column.sensor));
  }
}

void Recorder::mission(double mission_time_s, uint32_t state) {
  const size_t first = trace_.rows.size() - trace_.columns.size();
  trace_.rows[first + kMissionTimeColumn] = mission_time_s;
  trace_.rows[first + kStateColumn] = state;
}

void Recorder::field() {
  const size_t rows = trace_.rowCount();
  if (rows == 0) {
    return;
  }
  const int time = trace_.column("time"), depth = trace_.column("true_depth");
  const int x = trace_.column("true_x"), y = trace_.column("true_y");
  double deepest = 1;
  for (size_t i = 0; i < rows; ++i) {
    deepest = std::max(deepest, trace_.at(i, depth));
  }
  constexpr double kMargin = 1.15;  // the field's depth as a multiple of the flight's
  // The bottom may be deeper than at the start.
  const double bottom = std::min(deepest * kMargin + 1, std::max(deepest, ocean_.waterDepth(0, 0)));
  for (size_t j = 0; j < kDepths; ++j) {
    trace_.field.depths_m.push_back(bottom * static_cast<double>(j) / (kDepths - 1));
  }
  const size_t times = std::min(rows, kMostTimes);
  for (size_t i = 0; i < times; ++i) {
    const size_t row = times == 1 ? 0 : i * (rows - 1) / (times - 1);
    const double t = trace_.at(row, time);
    trace_.field.times_s.push_back(t);
    for (const double z : trace_.field.depths_m) {
      trace_.field.values.push_back(ocean_.temperature(z, trace_.at(row, x), trace_.at(row, y), t));
    }
  }
}

}  // namespace glider::simulator
