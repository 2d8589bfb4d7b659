// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/track_map.h"

#include "report/figures.h"
#include "report/picture/flight_view.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace glider::report::picture {
namespace {

using support::Trace;

struct Track {
  std::vector<double> east, north;
};

Track trackOf(const Trace& trace, const char* east, const char* north) {
  return {valuesOf(trace, east), valuesOf(trace, north)};
}

class Map {
 public:
  Map(SvgText& svg, const Trace& trace, const Box& box)
      : svg_(svg),
        trace_(trace),
        box_(box),
        truth_(isKnown(trace, "true_x") ? trackOf(trace, "true_x", "true_y")
                                        : trackOf(trace, "m_x_lmc", "m_y_lmc")) {
    Track both = truth_;
    if (isKnown(trace, "true_x")) {
      reckoned_ = trackOf(trace, "m_x_lmc", "m_y_lmc");
      both.east.insert(both.east.end(), reckoned_.east.begin(), reckoned_.east.end());
      both.north.insert(both.north.end(), reckoned_.north.begin(), reckoned_.north.end());
    }
    const Extent east = extentOf(both.east), north = extentOf(both.north);
    constexpr double kMargin = 1.16, kLeast = 20;  // of the track's size; m
    metres_ =
        kMargin * std::max({east.greatest - east.least, north.greatest - north.least, kLeast});
    middle_ = {(east.least + east.greatest) / 2, (north.least + north.greatest) / 2};
  }

  void draw() {
    axes();
    addPath(svg_, "reckoned", {lineOf(reckoned_, 0, reckoned_.east.size())});
    flown();
    addFrame(svg_, box_);
    ends();
  }

 private:
  [[nodiscard]] Dot at(double east, double north) const {
    const double scale = box_.width() / metres_;
    return {(box_.left + box_.right) / 2 + (east - middle_.x) * scale,
            (box_.top + box_.bottom) / 2 - (north - middle_.y) * scale};
  }

  void axes() {
    constexpr double kKilometre = 1000;
    const bool km = metres_ > 5 * kKilometre;
    const double unit = km ? kKilometre : 1, half = metres_ / 2,
                 high = half * box_.height() / box_.width();
    const double step = niceStep(metres_ / unit, 6);
    addAcross(svg_, box_,
              Axis((middle_.x - half) / unit, (middle_.x + half) / unit, box_.left, box_.right),
              step, km ? "east (km)" : "east (m)");
    addUp(svg_, box_,
          Axis((middle_.y - high) / unit, (middle_.y + high) / unit, box_.bottom, box_.top), step,
          km ? "north (km)" : "north (m)");
  }

  /// Rows from `begin` to `end` of a track.
  [[nodiscard]] Line lineOf(const Track& track, size_t begin, size_t end) const {
    Line line;
    for (size_t row = begin; row <= end && row < track.east.size(); ++row) {
      if (std::isfinite(track.east[row]) && std::isfinite(track.north[row])) {
        line.push_back(at(track.east[row], track.north[row]));
      }
    }
    return simplified(line, 1.0 / 3);
  }

  void flown() {
    std::map<std::string, std::vector<Line>> by_colour;
    for (const Span& span : spansOf(trace_)) {
      by_colour[std::string(pilotColour(span.pilot))].push_back(
          lineOf(truth_, span.begin, span.end));
    }
    for (const auto& [colour, lines] : by_colour) {
      addPath(svg_, "track", colour, lines);
    }
  }

  void ends() {
    const Line line = lineOf(truth_, 0, truth_.east.size());
    const auto mark = [&](const Dot& dot, double up, std::string_view name) {
      const bool right = dot.x > (box_.left + box_.right) / 2;
      addText(svg_, {dot.x, dot.y + up}, right ? "end" : "start", "label halo", name);
    };
    const Dot &first = line.front(), &last = line.back();
    svg_.add("<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"5\"/>\n", px(first.x), px(first.y));
    svg_.add("<rect class=\"mark\" x=\"{}\" y=\"{}\" width=\"9\" height=\"9\"/>\n",
             px(last.x - 4.5), px(last.y - 4.5));
    // The upper one's name stands above, the lower one's below.
    const bool first_above = first.y <= last.y;
    mark(first, first_above ? -10 : 20, "start");
    mark(last, first_above ? 20 : -10, "end");
  }

  SvgText& svg_;
  const Trace& trace_;
  Box box_;
  Track truth_, reckoned_;
  double metres_ = 1;
  Dot middle_;
};

}  // namespace

bool deservesMap(const Trace& trace) {
  constexpr double kStraight = 0.8, kWorth = 300;  // of the way; m
  const FlightFigures figures = flightFigures(trace);
  return figures.distance_m > kWorth && figures.made_good_m < kStraight * figures.distance_m;
}

void drawMap(SvgText& svg, const Trace& trace, const Box& box) {
  Map(svg, trace, box).draw();
}

}  // namespace glider::report::picture
