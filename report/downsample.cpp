// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/downsample.h"

#include "report/figures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace glider::report {

namespace {

using support::Trace;

void keepExtremes(const Trace& trace, int depth, size_t begin, size_t end,
                  std::vector<bool>& keep) {
  keep[begin] = true;
  if (depth < 0) {
    return;
  }
  size_t shallowest = end;
  size_t deepest = end;
  for (size_t row = begin; row < end; ++row) {
    const double here = trace.at(row, depth);
    if (std::isnan(here)) {
      continue;
    }
    if (shallowest == end || here < trace.at(shallowest, depth)) {
      shallowest = row;
    }
    if (deepest == end || here > trace.at(deepest, depth)) {
      deepest = row;
    }
  }
  if (shallowest != end) {
    keep[shallowest] = true;
    keep[deepest] = true;
  }
}

/// Keeps the rows beside those where a column changes or becomes known or unknown; `same`: of two
/// values.
template <typename Same>
void keepChanges(const Trace& trace, int column, std::vector<bool>& keep, Same same) {
  for (size_t row = 1; column >= 0 && row < keep.size(); ++row) {
    const double before = trace.at(row - 1, column);
    const double now = trace.at(row, column);
    if (std::isnan(before) != std::isnan(now) || !(std::isnan(now) || same(before, now))) {
      keep[row - 1] = true;
      keep[row] = true;
    }
  }
}

}  // namespace

Trace downsampled(const Trace& trace, size_t most) {
  const size_t count = trace.rowCount();
  if (count <= most) {
    return trace;
  }
  std::vector<bool> keep(count, false);
  keep.back() = true;
  const size_t stretches = std::max<size_t>(1, most / 3);
  const int depth = depthColumn(trace);
  for (size_t i = 0; i < stretches; ++i) {
    keepExtremes(trace, depth, i * count / stretches, (i + 1) * count / stretches, keep);
  }
  for (const TurningPoint& point : turningPoints(trace)) {
    keep[point.row] = true;
  }
  for (const char* name : {"state", "hook_active", "dr_leg", "current_x", "gps_x"}) {
    keepChanges(trace, trace.column(name), keep, std::equal_to<>());
  }
  // A gap in the depth, over which no line may be drawn.
  keepChanges(trace, depth, keep, [](double, double) { return true; });

  Trace out = trace;
  out.rows.clear();
  const auto width = static_cast<std::ptrdiff_t>(trace.columns.size());
  for (size_t row = 0; row < count; ++row) {
    if (keep[row]) {
      const auto first = trace.rows.begin() + static_cast<std::ptrdiff_t>(row) * width;
      out.rows.insert(out.rows.end(), first, first + width);
    }
  }
  return out;
}

}  // namespace glider::report
