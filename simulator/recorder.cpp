// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace glider::simulator {
namespace {

constexpr double kNotRecorded = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kMissionTimeColumn = 1, kStateColumn = 2;
constexpr size_t kMostTimes = 400, kDepths = 80;

}  // namespace

Recorder::Recorder(support::Trace& trace, const World& world, const SimulatedSeat& seat,
                   const platforms::Platform& platform, const Scenario& scenario)
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

void Recorder::row(double now_s, const Vehicle& vehicle) {
  const double x = vehicle.x(), y = vehicle.y();
  const double isotherm =
      std::isnan(isotherm_) ? kNotRecorded : ocean_.isothermDepth(isotherm_, x, y, now_s);
  const ColumnMoment moment{
      now_s, seat_, vehicle, frame_.position(x, y), isotherm, ocean_.waterDepth(x, y)};
  for (const RecorderColumn& column : columns_) {
    trace_.rows.push_back(column.value != nullptr ? column.value(moment)
                                                  : seat_.recorded(column.sensor));
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
