// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/fleet/fleet_report.h"
#include "report/picture/colours.h"
#include "report/picture/flight_view.h"
#include "report/picture/legend.h"
#include "report/picture/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::report {

using namespace picture;

namespace {

constexpr double kHour_s = 3600;
constexpr double kChartLeft = 70, kChartTop = 14, kChartWide = 860, kChartHigh = 260,
                 kChartRight = 16;
constexpr double kBelowChart = 58;
constexpr int kTimeTicks = 10, kValueTicks = 6;

/// One line of a chart: hours, and values; NaN and infinity interrupt it.
struct Series {
  std::string name, colour;
  std::vector<double> hours, values;
};

struct ChartText {
  std::string title, axis;
  bool downwards = false;  ///< zero is at the top
};

std::vector<Line> linesOf(const Series& series, const Axis& x, const Axis& y) {
  std::vector<Line> lines(1);
  for (size_t i = 0; i < series.hours.size(); ++i) {
    if (std::isfinite(series.values[i])) {
      lines.back().push_back({x.at(series.hours[i]), y.at(series.values[i])});
    } else if (!lines.back().empty()) {
      lines.emplace_back();
    }
  }
  for (Line& line : lines) {
    line = simplified(line, kUnseen);
  }
  return lines;
}

double greatestOf(const std::vector<Series>& all, std::vector<double> Series::* member) {
  double greatest = 0;
  for (const Series& series : all) {
    for (const double value : series.*member) {
      greatest = std::isfinite(value) ? std::max(greatest, value) : greatest;
    }
  }
  return greatest;
}

/// A chart over time with a zero, a line for each series, and a level that is drawn dashed (empty:
/// none).
std::string drawChart(const ChartText& text, const std::vector<Series>& all,
                      std::optional<double> level = {}) {
  constexpr double kRoom = 1.06;
  const double hours = std::max(greatestOf(all, &Series::hours), 1e-3);
  const double most = kRoom * std::max({greatestOf(all, &Series::values), level.value_or(0), 1.0});
  const Box box{kChartLeft, kChartTop, kChartLeft + kChartWide, kChartTop + kChartHigh};
  const Axis x(0, hours, box.left, box.right);
  const Axis y =
      text.downwards ? Axis(most, 0, box.bottom, box.top) : Axis(0, most, box.bottom, box.top);
  SvgText body;
  addAcross(body, box, x, niceStep(hours, kTimeTicks), "time (h)");
  addUp(body, box, y, niceStep(most, kValueTicks), text.axis);
  std::vector<LegendEntry> legend;
  for (const Series& series : all) {
    addPaths(body, "track thin", {{series.colour, linesOf(series, x, y)}});
    legend.push_back({"swatch", series.colour, series.name});
  }
  if (level) {
    addPath(body, "marked", {{{box.left, y.at(*level)}, {box.right, y.at(*level)}}});
    legend.push_back({"marked", "", "required"});
  }
  addFrame(body, box);
  const double below = box.bottom + kBelowChart;
  const double high = drawLegend(body, legend, {box.left, below}, kChartWide);
  SvgText svg;
  beginPage(svg, box.right + kChartRight, below + high, text.title);
  svg.add("<style>.thin {{ stroke-width: 1.4 }}</style>\n");
  svg.add(body.take());
  svg.add("</svg>\n");
  return svg.take();
}

std::vector<double> toHours(std::vector<double> seconds) {
  for (double& value : seconds) {
    value /= kHour_s;
  }
  return seconds;
}

}  // namespace

std::string drawFleetDepths(const FleetReport& fleet) {
  std::vector<Series> all;
  for (size_t i = 0; i < fleet.vehicles.size(); ++i) {
    const FleetVehicleReport& vehicle = fleet.vehicles[i];
    all.push_back(
        {vehicle.name, vehicleColour(fleet, i), toHours(vehicle.times_s), vehicle.depths_m});
  }
  return drawChart({"the depths of the fleet " + fleet.name, "depth (m)", true}, all);
}

std::string drawFleetDistances(const FleetReport& fleet) {
  std::vector<const FleetPairReport*> nearest;
  for (const FleetPairReport& pair : fleet.pairs) {
    if (std::isfinite(pair.least_m)) {
      nearest.push_back(&pair);
    }
  }
  if (nearest.empty()) {
    return "";
  }
  std::ranges::stable_sort(nearest, {}, [](const FleetPairReport* pair) { return pair->least_m; });
  nearest.resize(std::min(nearest.size(), kMostDrawnPairs));
  std::vector<Series> all;
  for (size_t i = 0; i < nearest.size(); ++i) {
    const FleetPairReport& pair = *nearest[i];
    all.push_back(
        {fmt::format("{} – {}", fleet.vehicles[pair.one].name, fleet.vehicles[pair.other].name),
         std::string(stateColour(static_cast<double>(i))), toHours(fleet.times_s), pair.series_m});
  }
  return drawChart({"the distances between vehicles of the fleet " + fleet.name, "distance (m)"},
                   all, fleet.separation_m);
}

}  // namespace glider::report
