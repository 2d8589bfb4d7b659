// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glider::report::picture {

/// What controls the vehicle if no state does: the vehicle's layered control, or a payload computer
/// whose mission is written in C.
inline constexpr double kLayered = -1, kStateless = -2;

/// A stretch of rows in which one state controls the vehicle, or no state. `end` is the first row
/// of the next stretch, or the last row of all or before a gap of the log.
struct Span {
  size_t begin = 0, end = 0;
  double pilot = kLayered;  ///< number of a state, kLayered or kStateless
};

/// The values of column `name`, one for each row; all unknown (NaN) if there is no such column.
std::vector<double> valuesOf(const support::Trace& trace, std::string_view name);
/// Whether column `name` exists and has a known value.
bool isKnown(const support::Trace& trace, std::string_view name);
/// False if the trace does not say at all what controls the vehicle, or what it does: a log of few
/// sensors.
bool hasPilots(const support::Trace& trace);
/// What controls the vehicle, one for each row.
std::vector<double> pilotsOf(const support::Trace& trace);
/// The stretches in order. One ends where the next begins, unless a gap of the log is between them.
std::vector<Span> spansOf(const support::Trace& trace);
/// The name in a picture of what controls the vehicle.
std::string pilotName(const support::Trace& trace, double pilot);
/// The colour of what controls the vehicle.
std::string_view pilotColour(double pilot);

/// The least and the greatest of the known `values`; both NaN if there are none.
struct Extent {
  double least, greatest;
};
Extent extentOf(const std::vector<double>& values);

}  // namespace glider::report::picture
