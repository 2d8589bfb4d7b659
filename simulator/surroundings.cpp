// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/surroundings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace glider::simulator {
namespace {

constexpr size_t kMostTimes = 400, kDepths = 80;
constexpr size_t kBottomPoints = 60;  // of its grid, along each side
constexpr double kLeastExtent = 200;  // m, of the track, for the margin around it

struct Stretch {
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

Stretch stretchOf(const support::Trace& trace, std::string_view name) {
  const int column = trace.column(name);
  Stretch of;
  for (size_t i = 0; i < trace.rowCount(); ++i) {
    // fmin and fmax ignore NaN.
    of.low = std::fmin(of.low, trace.at(i, column));
    of.high = std::fmax(of.high, trace.at(i, column));
  }
  return of;
}

std::vector<double> gridLines(const Stretch& of, double margin) {
  const double from = of.low - margin, length = of.high - of.low + 2 * margin;
  std::vector<double> lines;
  for (size_t i = 0; i < kBottomPoints; ++i) {
    lines.push_back(from + length * static_cast<double>(i) / (kBottomPoints - 1));
  }
  return lines;
}

}  // namespace

support::TraceField waterAlong(const support::Trace& trace, const Ocean& ocean) {
  const size_t rows = trace.rowCount();
  const int time = trace.column("time"), depth = trace.column("true_depth");
  const int x = trace.column("true_x"), y = trace.column("true_y");
  double deepest = 1;
  for (size_t i = 0; i < rows; ++i) {
    deepest = std::max(deepest, trace.at(i, depth));
  }
  support::TraceField field;
  constexpr double kMargin = 1.15;  // the field's depth as a multiple of the flight's
  // The bottom may be deeper than at the start.
  const double bottom = std::min(deepest * kMargin + 1, std::max(deepest, ocean.waterDepth(0, 0)));
  for (size_t j = 0; j < kDepths; ++j) {
    field.depths_m.push_back(bottom * static_cast<double>(j) / (kDepths - 1));
  }
  const size_t times = std::min(rows, kMostTimes);
  for (size_t i = 0; i < times; ++i) {
    const size_t row = times == 1 ? 0 : i * (rows - 1) / (times - 1);
    const double t = trace.at(row, time);
    field.times_s.push_back(t);
    for (const double z : field.depths_m) {
      field.values.push_back(ocean.temperature(z, trace.at(row, x), trace.at(row, y), t));
    }
  }
  return field;
}

support::BottomGrid bottomAround(const support::Trace& trace, const Ocean& ocean) {
  const Stretch east = stretchOf(trace, "true_x"), north = stretchOf(trace, "true_y");
  const double extent = std::max({east.high - east.low, north.high - north.low, kLeastExtent});
  support::BottomGrid grid{gridLines(east, extent / 2), gridLines(north, extent / 2), {}};
  for (const double x : grid.x_m) {
    for (const double y : grid.y_m) {
      grid.depths_m.push_back(ocean.waterDepth(x, y));
    }
  }
  const auto [least, greatest] = std::ranges::minmax(grid.depths_m);
  return greatest > least ? grid : support::BottomGrid{};
}

}  // namespace glider::simulator
