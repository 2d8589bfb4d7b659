// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/flight_view.h"

#include "report/figures.h"
#include "report/picture/colours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glider::report::picture {

using support::Trace;

std::vector<double> valuesOf(const Trace& trace, std::string_view name) {
  const int column = trace.column(name);
  std::vector<double> values(trace.rowCount(), std::numeric_limits<double>::quiet_NaN());
  for (size_t row = 0; column >= 0 && row < values.size(); ++row) {
    values[row] = trace.at(row, column);
  }
  return values;
}

bool isKnown(const Trace& trace, std::string_view name) {
  return std::ranges::any_of(valuesOf(trace, name), [](double v) { return std::isfinite(v); });
}

bool hasPilots(const Trace& trace) {
  return !trace.log || isKnown(trace, "state");
}

std::vector<double> pilotsOf(const Trace& trace) {
  std::vector<double> pilots = valuesOf(trace, "state");
  const auto active = valuesOf(trace, "hook_active");
  // Taking and releasing control each last a cycle in which hookbeh is active before the first
  // state or after the last: no state is current then. Only a mission in C has none throughout.
  const bool stateless = !isKnown(trace, "state");
  for (size_t row = 0; row < pilots.size(); ++row) {
    if (!(pilots[row] >= 0)) {
      pilots[row] = stateless && active[row] > 0 ? kStateless : kLayered;
    }
  }
  return pilots;
}

std::vector<Span> spansOf(const Trace& trace) {
  std::vector<Span> spans;
  const auto pilots = pilotsOf(trace), times = valuesOf(trace, "time");
  const auto gapAfter = [&](size_t row) {
    return row + 1 < times.size() && trace.isGap(times[row], times[row + 1]);
  };
  for (size_t row = 0; row < pilots.size(); ++row) {
    const bool cut = row > 0 && gapAfter(row - 1);
    if (cut && gapAfter(row)) {
      continue;  // in the middle of a gap
    }
    if (!spans.empty() && !cut) {
      spans.back().end = row;
    }
    if (spans.empty() || cut || spans.back().pilot != pilots[row]) {
      spans.push_back({row, row, pilots[row]});
    }
  }
  return spans;
}

std::string pilotName(const Trace& trace, double pilot) {
  return pilot == kLayered     ? (trace.log ? "state not known" : "layered control")
         : pilot == kStateless ? "payload computer"
                               : stateName(trace, pilot);
}

std::string_view pilotColour(double pilot) {
  return pilot == kLayered ? kGrey : stateColour(pilot);
}

Extent extentOf(const std::vector<double>& values) {
  Extent extent{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  for (const double value : values) {
    if (std::isfinite(value)) {
      extent = {std::fmin(extent.least, value), std::fmax(extent.greatest, value)};
    }
  }
  return extent;
}

}  // namespace glider::report::picture
