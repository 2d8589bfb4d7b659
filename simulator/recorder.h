// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/scenario/scenario.h"
#include "simulator/seat/simulated_seat.h"
#include "support/trace/trace.h"

#include <span>
#include <string>
#include <vector>

namespace glider::simulator {

/// A column of the trace: the value of a function of the cycle, or, without a function, the newest
/// reading of a sensor.
struct RecorderColumn {
  double (*value)(const ColumnMoment& moment) = nullptr;
  uint16_t sensor = 0;
  bool of_instrument = false;    ///< not known while the instrument is off
  bool degrees_minutes = false;  ///< ddmm.mmmm, becomes degrees
};

/// Writes the trace's rows.
class Recorder {
 public:
  /// `also`: sensors that get a column even if no flight needs it, by the vehicle's names. All that
  /// it is given outlives it.
  Recorder(support::Trace& trace, const World& world, const SimulatedSeat& seat,
           const platforms::Platform& platform, const Scenario& scenario,
           std::span<const std::string> also);

  /// The row of the control cycle at `now_s`.
  void row(double now_s, const Vehicle& vehicle);
  /// What the SBC's mission reported in answer to the newest row.
  void mission(double mission_time_s, uint32_t state);

 private:
  /// The columns of the instruments on board: those that every vehicle has, or the others.
  void addInstruments(const platforms::Platform& platform, const Scenario& scenario,
                      bool of_each_vehicle);
  void addSensors(const platforms::Platform& platform, std::span<const std::string> names);
  [[nodiscard]] double readingOf(const RecorderColumn& column) const;

  support::Trace& trace_;
  const Ocean& ocean_;
  const LocalFrame& frame_;
  const SimulatedSeat& seat_;
  double isotherm_;
  std::vector<RecorderColumn> columns_;
};

}  // namespace glider::simulator
