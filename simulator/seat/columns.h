// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/geography/local_frame.h"
#include "simulator/scenario/scenario.h"
#include "simulator/vehicle/vehicle.h"

namespace glider::simulator {

class SimulatedSeat;

/// The sources of a row of the trace.
struct ColumnMoment {
  double now_s;
  const SimulatedSeat& seat;
  const Vehicle& vehicle;
  GeoPosition truth;
  double isotherm_m, water_depth_m;
  Planar current;           ///< of the water around the vehicle, m/s
  double used_at_start_Wh;  ///< of a full pack, when the flight began
};

/// A column of the trace.
struct Column {
  const char* name;
  const char* unit;
  double (*value)(const ColumnMoment& moment);
  /// Whether a scenario needs the column; null: every scenario does.
  bool (*wanted)(const Scenario& scenario) = nullptr;
};

}  // namespace glider::simulator
