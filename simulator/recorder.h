// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/flight/flight_controller.h"
#include "simulator/scenario/scenario.h"
#include "simulator/science/science_computer.h"
#include "support/trace/trace.h"

#include <vector>

namespace glider::simulator {

/// Writes the trace's rows and its field of temperatures.
class Recorder {
 public:
  Recorder(support::Trace& trace, const Ocean& ocean, const LocalFrame& frame,
           const Scenario& scenario);

  /// The row of the control cycle at `now_s`.
  void row(double now_s, const FlightController& flight, const ScienceComputer& science,
           const Vehicle& vehicle);
  /// What the SBC's mission said of itself in answer to the newest row.
  void mission(double mission_time_s, uint32_t state);
  /// After the last row: the water along the flight.
  void field();

 private:
  support::Trace& trace_;
  const Ocean& ocean_;
  const LocalFrame& frame_;
  double isotherm_;
  std::vector<size_t> columns_;  ///< places in recorder.cpp's list of those that are written
};

}  // namespace glider::simulator
