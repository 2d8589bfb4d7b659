// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/picture.h"

#include "report/figures.h"
#include "report/picture/colours.h"
#include "report/picture/depth_chart.h"
#include "report/picture/track_map.h"
#include "report/svg/text_lines.h"
#include "report/text.h"
#include "support/utc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::report {
namespace {

using namespace picture;
using support::Trace;

constexpr double kLeft = 62, kPictureMargin = 16, kPictureTop = 92, kPictureHigh = 320,
                 kMapWide = 320, kMapLeft = 70;
constexpr double kPictureWide = 940, kWideWithMap = 1080, kPictureAxisRoom = 62;

std::string headlineOf(const Trace& trace) {
  const FlightFigures figures = flightFigures(trace);
  std::string text = trace.log ? "from " + support::utcText(trace.log->utc_s) + " UTC"
                               : "scenario " + plain(trace.scenario);
  if (std::isfinite(figures.duration_s)) {
    const auto minutes = static_cast<long>(std::lround(figures.duration_s / 60));
    text += minutes >= 100 ? fmt::format(" · {} h {:02} min", minutes / 60, minutes % 60)
                           : fmt::format(" · {} min", minutes);
  }
  if (std::isfinite(figures.deepest_m)) {
    text += fmt::format(" · {} yo{} to {:.0f} m", figures.yos, figures.yos == 1 ? "" : "s",
                        figures.deepest_m);
  }
  if (figures.track != TrackSource::None) {
    text += fmt::format(" · {:.1f} km {}", figures.distance_m / 1000,
                        trace.log ? "dead-reckoned track" : "over ground");
  }
  return text;
}

/// The states of the flight, each once, in the mission's order, then the time without a state.
std::vector<LegendEntry> pilotEntries(const Trace& trace) {
  if (!hasPilots(trace)) {
    return {};
  }
  std::vector<double> pilots;
  for (const Span& span : spansOf(trace)) {
    if (std::ranges::find(pilots, span.pilot) == pilots.end()) {
      pilots.push_back(span.pilot);
    }
  }
  std::ranges::sort(pilots, {}, [](double pilot) { return pilot < 0 ? 1e9 - pilot : pilot; });
  std::vector<LegendEntry> entries;
  for (const double pilot : pilots) {
    entries.push_back({"swatch", std::string(pilotColour(pilot)), pilotName(trace, pilot)});
  }
  return entries;
}

/// Names the grey of the track where the quantity is unknown. In a log the grey of an unknown state
/// means the same.
void nameUnknown(const Trace& trace, std::vector<LegendEntry>& legend) {
  const auto grey = std::ranges::find(legend, kGrey, &LegendEntry::colour);
  if (trace.log && grey != legend.end()) {
    grey->text = "not known";
  } else {
    legend.push_back({"swatch", std::string(kGrey), "not known"});
  }
}

}  // namespace

std::string drawPicture(const Trace& trace, const PictureStyle& style) {
  const bool map = deservesMap(trace);
  const double width = map ? kWideWithMap : kPictureWide;
  const Colouring colouring(trace, style);
  const double right = width - kPictureMargin - (map ? kMapLeft + kMapWide : 0) -
                       (colouring.quantity() ? kScaleRoom : 0);
  const Box box{kLeft, kPictureTop, right, kPictureTop + kPictureHigh};
  SvgText body;
  std::vector<LegendEntry> legend = pilotEntries(trace);
  const auto drawn = drawDepthChart(body, trace, colouring, box);
  legend.insert(legend.end(), drawn.begin(), drawn.end());
  if (colouring.quantity()) {
    drawScale(body, colouring, box);
    if (colouring.hasUnknown()) {
      nameUnknown(trace, legend);
    }
  }
  if (map) {
    const auto mapped = drawMap(body, trace,
                                {width - kPictureMargin - kMapWide, kPictureTop,
                                 width - kPictureMargin, kPictureTop + kPictureHigh});
    legend.insert(legend.end(), mapped.begin(), mapped.end());
  }
  const double legend_top = box.bottom + kPictureAxisRoom;
  const double height =
      legend_top + drawLegend(body, legend, {kLeft, legend_top}, width - kLeft - kPictureMargin) +
      2;
  const std::string name = trace.mission.empty() ? "layered control" : plain(flightTitle(trace));
  SvgText svg;
  beginPage(svg, width, height, "the flight of mission " + name);
  addText(svg, {kLeft, 30}, "start", "title", name);
  addText(svg, {kLeft, 51}, "start", "muted", headlineOf(trace));
  svg.add(body.take());
  svg.add("</svg>\n");
  return svg.take();
}

}  // namespace glider::report
