// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/recorder.h"

#include "hooks/protocol/sensors.h"
#include "simulator/geography/ddmm.h"
#include "simulator/sensors/provided.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace glider::simulator {
namespace {

constexpr double kNotRecorded = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kMissionTimeColumn = 1, kStateColumn = 2;

// The columns after all others: a column that is added keeps the places of the earlier ones.
constexpr Column kLast[] = {
    {"energy", "Wh",
     [](const ColumnMoment& m) {
       return m.vehicle.battery().usedJ() / kJoulesPerWattHour - m.used_at_start_Wh;
     }},
    {"true_current_x", "m/s", [](const ColumnMoment& m) { return m.current.east; }},
    {"true_current_y", "m/s", [](const ColumnMoment& m) { return m.current.north; }},
};

}  // namespace

Recorder::Recorder(support::Trace& trace, const World& world, const SimulatedSeat& seat,
                   const platforms::Platform& platform, const Scenario& scenario,
                   std::span<const std::string> also)
    : trace_(trace),
      ocean_(world.ocean()),
      frame_(world.frame()),
      seat_(seat),
      isotherm_(scenario.isotherm_degC) {
  const auto add = [&](std::span<const Column> columns) {
    for (const Column& column : columns) {
      if (column.wanted == nullptr || column.wanted(scenario)) {
        columns_.push_back({column.value});
        trace_.columns.push_back({column.name, column.unit});
      }
    }
  };
  add(seat.firstColumns());
  addInstruments(platform, scenario, true);
  add(seat.secondColumns());
  addInstruments(platform, scenario, false);
  add(kLast);
  addSensors(platform, also);
}

void Recorder::addInstruments(const platforms::Platform& platform, const Scenario& scenario,
                              bool of_each_vehicle) {
  for (const std::unique_ptr<Instrument>& instrument : makeInstruments(0, scenario.sensors)) {
    if (!instrument->carried() || instrument->setting().empty() != of_each_vehicle) {
      continue;
    }
    for (const InstrumentSensor& sensor : instrument->sensors()) {
      const bool there = numberOf(platform, sensor.name) != hooks::kNoSensor;
      if (sensor.column_unit != nullptr && there) {
        columns_.push_back({nullptr, numberOf(platform, sensor.name), true});
        trace_.columns.push_back({std::string(sensor.name), sensor.column_unit});
      }
    }
  }
}

void Recorder::addSensors(const platforms::Platform& platform, std::span<const std::string> names) {
  for (const std::string& name : names) {
    const platforms::PlatformSensor* sensor = platform.find(name);
    if (sensor == nullptr || trace_.column(name) >= 0) {
      continue;
    }
    const bool position = sensor->unit == "lat" || sensor->unit == "lon";
    const bool science = sensor->computer == platforms::Computer::Science;
    columns_.push_back({nullptr, sensor->id, science, position});
    trace_.columns.push_back({name, position ? "deg" : sensor->unit == "1" ? "" : sensor->unit});
  }
}

double Recorder::readingOf(const RecorderColumn& column) const {
  const double value =
      column.of_instrument ? seat_.recorded(column.sensor) : seat_.reading(column.sensor);
  return column.degrees_minutes ? fromDdmm(value) : value;
}

void Recorder::row(double now_s, const Vehicle& vehicle) {
  const double x = vehicle.x(), y = vehicle.y();
  const double isotherm =
      std::isnan(isotherm_) ? kNotRecorded : ocean_.isothermDepth(isotherm_, x, y, now_s);
  const ColumnMoment moment{now_s,
                            seat_,
                            vehicle,
                            frame_.position(x, y),
                            isotherm,
                            ocean_.waterDepth(x, y),
                            ocean_.current(vehicle.depth(), x, y),
                            trace_.battery ? trace_.battery->used_Wh : 0};
  for (const RecorderColumn& column : columns_) {
    trace_.rows.push_back(column.value != nullptr ? column.value(moment) : readingOf(column));
  }
}

void Recorder::mission(double mission_time_s, uint32_t state) {
  const size_t first = trace_.rows.size() - trace_.columns.size();
  trace_.rows[first + kMissionTimeColumn] = mission_time_s;
  trace_.rows[first + kStateColumn] = state;
}

}  // namespace glider::simulator
