// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glider::report::picture {

/// Who decides where there is no state: the vehicle's layered control, or a payload computer whose
/// mission is written in C.
inline constexpr double kLayered = -1, kStateless = -2;

/// A stretch of rows in which one state, or nobody on the payload computer, decides. `end` is the
/// first row of the next stretch, or the last row of all.
struct Span {
  size_t begin = 0, end = 0;
  double pilot = kLayered;  ///< number of a state, kLayered or kStateless
};

/// The values of column `name`, one a row; all unknown (NaN) if there is no such column.
std::vector<double> valuesOf(const support::Trace& trace, std::string_view name);
/// Whether column `name` is there and known somewhere.
bool isKnown(const support::Trace& trace, std::string_view name);
/// Who decides, one a row.
std::vector<double> pilotsOf(const support::Trace& trace);
/// The stretches in order, without a gap.
std::vector<Span> spansOf(const support::Trace& trace);
/// What a picture calls who decides.
std::string pilotName(const support::Trace& trace, double pilot);
/// The colour of who decides.
std::string_view pilotColour(double pilot);

/// The least and the greatest of `values` that are known; both NaN if none is.
struct Extent {
  double least, greatest;
};
Extent extentOf(const std::vector<double>& values);

}  // namespace glider::report::picture
