// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/scenario/scenario.h"
#include "simulator/seat/simulated_seat.h"
#include "support/trace/trace.h"

#include <vector>

namespace glider::simulator {

/// A column of the trace: the value of a function of the cycle, or, without a function, the newest
/// reading of a sensor of an instrument.
struct RecorderColumn {
  double (*value)(const ColumnMoment& moment) = nullptr;
  uint16_t sensor = 0;
};

/// Writes the trace's rows and its field of temperatures.
class Recorder {
 public:
  /// All that it is given outlives it.
  Recorder(support::Trace& trace, const World& world, const SimulatedSeat& seat,
           const platforms::Platform& platform, const Scenario& scenario);

  /// The row of the control cycle at `now_s`.
  void row(double now_s, const Vehicle& vehicle);
  /// What the SBC's mission reported in answer to the newest row.
  void mission(double mission_time_s, uint32_t state);
  /// After the last row: the water along the flight.
  void field();

 private:
  /// The columns of the instruments on board: those that every vehicle has, or the others.
  void addInstruments(const platforms::Platform& platform, const Scenario& scenario,
                      bool of_each_vehicle);

  support::Trace& trace_;
  const Ocean& ocean_;
  const LocalFrame& frame_;
  const SimulatedSeat& seat_;
  double isotherm_;
  std::vector<RecorderColumn> columns_;
};

}  // namespace glider::simulator
