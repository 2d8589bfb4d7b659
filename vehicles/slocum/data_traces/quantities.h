// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"
#include "vehicles/slocum/data_tables/merge.h"

#include <string>
#include <vector>

namespace glider::slocum {

/// A column of a trace while it is made: a value for each time.
struct FlightColumn {
  support::TraceColumn column;
  std::vector<double> values;
};

/// The sensors that quantities() uses, as patterns.
std::vector<std::string> quantitySensors();

/// What the vehicle and its instruments measured and what it was commanded, at `times_s`; all but
/// depth and position. `gaps`: without records, since the first of `times_s`.
std::vector<FlightColumn> quantities(const Merged& merged, const std::vector<double>& times_s,
                                     const std::vector<support::TraceGap>& gaps);

}  // namespace glider::slocum
