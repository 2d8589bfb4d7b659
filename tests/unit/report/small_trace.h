// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace glider::report {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A trace with these columns and rows, for tests that need to see every number.
inline support::Trace smallTrace(std::initializer_list<support::TraceColumn> columns,
                                 std::initializer_list<std::vector<double>> rows) {
  support::Trace trace;
  trace.mission = "survey";
  trace.scenario = "shelf";
  trace.way = "host";
  trace.seed = 3;
  trace.columns = columns;
  for (const std::vector<double>& row : rows) {
    trace.rows.insert(trace.rows.end(), row.begin(), row.end());
  }
  return trace;
}

}  // namespace glider::report
