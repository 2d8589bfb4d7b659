// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/recorder.h"

#include "simulator/flight/position.h"

#include <algorithm>
#include <cmath>

namespace glider::simulator {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const std::vector<support::TraceColumn>& columns() {
  static const std::vector<support::TraceColumn> kColumns = {{"time", "s"},
                                                             {"missiontime", "s"},
                                                             {"state", "id"},
                                                             {"m_depth", "m"},
                                                             {"true_depth", "m"},
                                                             {"m_pitch", "rad"},
                                                             {"c_pitch", "rad"},
                                                             {"m_heading", "rad"},
                                                             {"c_heading", "rad"},
                                                             {"m_lat", "deg"},
                                                             {"m_lon", "deg"},
                                                             {"true_lat", "deg"},
                                                             {"true_lon", "deg"},
                                                             {"m_x_lmc", "m"},
                                                             {"m_y_lmc", "m"},
                                                             {"true_x", "m"},
                                                             {"true_y", "m"},
                                                             {"sci_water_temp", "degC"},
                                                             {"m_ballast_pumped", "cc"},
                                                             {"c_ballast_pumped", "cc"},
                                                             {"m_battery", "V"},
                                                             {"m_depth_rate", "m/s"},
                                                             {"hook_active", ""},
                                                             {"hook_vertical", ""},
                                                             {"hook_depth", "m"},
                                                             {"order_top", "m"},
                                                             {"order_bottom", "m"},
                                                             {"isotherm_depth", "m"},
                                                             {"water_depth", "m"},
                                                             {"layer", ""}};
  return kColumns;
}

constexpr size_t kMissionTimeColumn = 1, kStateColumn = 2;
constexpr size_t kMostTimes = 400, kDepths = 80;

}  // namespace

Recorder::Recorder(support::Trace& trace, const Ocean& ocean, const LocalFrame& frame,
                   double isotherm_degC)
    : trace_(trace), ocean_(ocean), frame_(frame), isotherm_(isotherm_degC) {
  trace_.columns = columns();
}

void Recorder::row(double now_s, const FlightController& flight, const ScienceComputer& science,
                   const Vehicle& vehicle) {
  const SensorArray& a = flight.array();
  const HookOrder& order = flight.order();
  const double x = vehicle.x(), y = vehicle.y();
  const GeoPosition truth = frame_.position(x, y);
  const double isotherm =
      std::isnan(isotherm_) ? kNaN : ocean_.isothermDepth(isotherm_, x, y, now_s);
  const double row[] = {now_s,
                        kNaN,
                        kNaN,
                        a.get(GLIDER_M_DEPTH),
                        vehicle.depth(),
                        a.get(GLIDER_M_PITCH),
                        a.get(GLIDER_C_PITCH),
                        a.get(GLIDER_M_HEADING),
                        a.get(GLIDER_C_HEADING),
                        fromDdmm(a.get(GLIDER_M_LAT)),
                        fromDdmm(a.get(GLIDER_M_LON)),
                        truth.latitude_deg,
                        truth.longitude_deg,
                        a.get(GLIDER_M_X_LMC),
                        a.get(GLIDER_M_Y_LMC),
                        x,
                        y,
                        science.value(GLIDER_SCI_WATER_TEMP),
                        a.get(GLIDER_M_BALLAST_PUMPED),
                        a.get(GLIDER_C_BALLAST_PUMPED),
                        a.get(GLIDER_M_BATTERY),
                        a.get(GLIDER_M_DEPTH_RATE),
                        flight.hookActive() ? 1.0 : 0.0,
                        order.vertical,
                        order.depth_m,
                        order.top_m,
                        order.bottom_m,
                        isotherm,
                        ocean_.waterDepth(x, y),
                        flight.layer() == kNoLayer ? kNaN : flight.layer()};
  trace_.rows.insert(trace_.rows.end(), std::begin(row), std::end(row));
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
  constexpr double kMargin = 1.15;  // of water below the deepest point
  const double bottom = std::min(deepest * kMargin + 1, ocean_.waterDepth(0, 0));
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
