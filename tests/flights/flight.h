// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/support/command.h"

#include <string>
#include <vector>

namespace glider::tests {

/// One row of events.csv.
struct Event {
  double time_s = 0;
  double mission_time_s = 0;  ///< NaN when empty
  std::string kind, what, why;
};

/// What `glidercc sim` wrote.
struct Flight {
  Outcome outcome;
  std::string csv;  ///< trace.csv, whole
  std::vector<Event> events;
  std::vector<std::string> columns;       ///< names without units
  std::vector<std::vector<double>> rows;  ///< NaN for an empty cell

  /// The events of kind "transition".
  [[nodiscard]] std::vector<Event> transitions() const;
  /// All values of a column; fails the test if there is none.
  [[nodiscard]] std::vector<double> column(const std::string& name) const;
  /// The newest value of a column at that time of the flight; NaN before the first row.
  [[nodiscard]] double valueAt(const std::string& column, double time_s) const;
};

/// Flies `glidercc sim ARGUMENTS -o <temporary folder>` and reads what it wrote.
Flight fly(const std::string& arguments);

/// A file of the project.
std::string project(const std::string& path);

}  // namespace glider::tests
