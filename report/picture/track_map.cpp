// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/track_map.h"

#include "report/figures.h"
#include "report/picture/flight_view.h"
#include "report/picture/waypoints.h"

#include <algorithm>
#include <cmath>

namespace glider::report::picture {
namespace {

using support::Trace;

constexpr std::string_view kFixColour = "#b3206b";

struct Track {
  std::vector<double> east, north;
};

Track trackOf(const Trace& trace, const char* east, const char* north) {
  return {valuesOf(trace, east), valuesOf(trace, north)};
}

/// The place of a name, and on which side of its point it is.
struct Label {
  Dot place;
  bool to_left;
};

class Map {
 public:
  Map(SvgText& svg, const Trace& trace, const Box& box)
      : svg_(svg),
        trace_(trace),
        box_(box),
        truth_(isKnown(trace, "true_x")    ? trackOf(trace, "true_x", "true_y")
               : isKnown(trace, "m_x_lmc") ? trackOf(trace, "m_x_lmc", "m_y_lmc")
                                           : trackOf(trace, "dr_x", "dr_y")),
        legs_(valuesOf(trace, "dr_leg")),
        fixes_(trackOf(trace, "gps_x", "gps_y")),
        beside_(trackOf(trace, "sim_x", "sim_y")) {
    Track both = truth_;  // and everything else on the map
    if (isKnown(trace, "true_x")) {
      reckoned_ = trackOf(trace, "m_x_lmc", "m_y_lmc");
      both.east.insert(both.east.end(), reckoned_.east.begin(), reckoned_.east.end());
      both.north.insert(both.north.end(), reckoned_.north.begin(), reckoned_.north.end());
    }
    both.east.insert(both.east.end(), fixes_.east.begin(), fixes_.east.end());
    both.north.insert(both.north.end(), fixes_.north.begin(), fixes_.north.end());
    both.east.insert(both.east.end(), beside_.east.begin(), beside_.east.end());
    both.north.insert(both.north.end(), beside_.north.begin(), beside_.north.end());
    for (const Dot& dot : waypoints_) {
      both.east.push_back(dot.x);
      both.north.push_back(dot.y);
    }
    const Extent east = extentOf(both.east), north = extentOf(both.north);
    constexpr double kMargin = 1.16, kLeast = 20;  // of the track's size; m
    metres_ =
        kMargin * std::max({east.greatest - east.least, north.greatest - north.least, kLeast});
    middle_ = {(east.least + east.greatest) / 2, (north.least + north.greatest) / 2};
  }

  std::vector<LegendEntry> draw() {
    axes();
    addPath(svg_, "reckoned", {lineOf(reckoned_, 0, reckoned_.east.size())});
    flown();
    // The depth chart's legend names it.
    addPath(svg_, "beside", {lineOf(beside_, 0, beside_.east.size())});
    const bool has_fixes = drawFixes();
    addFrame(svg_, box_);
    ends();
    waypoints();
    std::vector<LegendEntry> legend;
    if (!reckoned_.east.empty()) {
      legend.push_back({"reckoned", "", "dead-reckoned track"});
    }
    if (has_fixes) {
      legend.push_back({"swatch", std::string(kFixColour), "GPS fix"});
    }
    if (!waypoints_.empty()) {
      legend.push_back({"waypoint", "", "waypoint"});
    }
    return legend;
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
    return simplified(line, kUnseen);
  }

  void flown() {
    ColouredLines by_colour;
    for (const Span& span : spansOf(trace_)) {
      std::vector<Line>& lines = by_colour[std::string(pilotColour(span.pilot))];
      size_t begin = span.begin;
      for (size_t row = span.begin + 1; row <= span.end; ++row) {
        // A GPS fix has moved the dead-reckoned position: no track leads there.
        if (std::isfinite(legs_[row]) && legs_[row] > legs_[row - 1]) {
          lines.push_back(lineOf(truth_, begin, row - 1));
          begin = row;
        }
      }
      lines.push_back(lineOf(truth_, begin, span.end));
    }
    addPaths(svg_, "track", by_colour);
  }

  /// False if there are none.
  bool drawFixes() {
    bool any = false;
    for (size_t row = 0; row < fixes_.east.size(); ++row) {
      if (std::isfinite(fixes_.east[row])) {
        const Dot dot = at(fixes_.east[row], fixes_.north[row]);
        svg_.add("<circle cx=\"{}\" cy=\"{}\" r=\"2.5\" fill=\"{}\"/>\n", px(dot.x), px(dot.y),
                 kFixColour);
        any = true;
      }
    }
    return any;
  }

  void waypoints() {
    for (const Dot& waypoint : waypoints_) {
      drawDiamond(svg_, at(waypoint.x, waypoint.y));
    }
  }

  /// A place for the text `name` near `dot` that does not cover a waypoint or leave the map: the
  /// first suitable one of four places, beginning on the side that faces the middle.
  [[nodiscard]] Label labelAt(const Dot& dot, double up_first, std::string_view name) const {
    constexpr double kAbove = -13, kBelow = 21, kClear = 7;
    const double wide = textWidth(name, kLabelFont), first = up_first < 0 ? kAbove : kBelow;
    const bool to_left = dot.x > (box_.left + box_.right) / 2;
    const Label wanted{{dot.x, dot.y + first}, to_left};
    for (const double up : {first, first == kAbove ? kBelow : kAbove}) {
      for (const bool left : {to_left, !to_left}) {
        const double x = left ? dot.x - wide : dot.x, y = dot.y + up - kLabelFont;
        const auto covers = [&](const Dot& waypoint) {
          const Dot mark = at(waypoint.x, waypoint.y);
          return mark.x > x - kClear && mark.x < x + wide + kClear && mark.y > y - kClear &&
                 mark.y < y + kLabelFont + kClear;
        };
        if (std::ranges::none_of(waypoints_, covers) && x > box_.left && x + wide < box_.right &&
            y > box_.top && y + kLabelFont < box_.bottom) {
          return {{dot.x, dot.y + up}, left};
        }
      }
    }
    return wanted;
  }

  void ends() {
    const Line line = lineOf(truth_, 0, truth_.east.size());
    const Dot &first = line.front(), &last = line.back();
    svg_.add("<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"7\"/>\n", px(first.x), px(first.y));
    svg_.add("<rect class=\"mark\" x=\"{}\" y=\"{}\" width=\"9\" height=\"9\"/>\n",
             px(last.x - 4.5), px(last.y - 4.5));
    // The name of the upper one is above it, that of the lower one below.
    const double up = first.y <= last.y ? -1 : 1;
    const auto name = [&](const Label& label, std::string_view text) {
      addText(svg_, label.place, label.to_left ? "end" : "start", "label halo", text);
    };
    name(labelAt(first, up, "start"), "start");
    name(labelAt(last, -up, "end"), "end");
  }

  SvgText& svg_;
  const Trace& trace_;
  Box box_;
  Track truth_, reckoned_;
  std::vector<double> legs_;  ///< of a log, see report/README.md
  Track fixes_;
  Track beside_;  ///< of the simulated flight
  std::vector<Dot> waypoints_ = waypointsOf(trace_);
  double metres_ = 1;
  Dot middle_;
};

}  // namespace

bool deservesMap(const Trace& trace) {
  constexpr double kStraight = 0.8, kWorth = 300;  // of the way; m
  const FlightFigures figures = flightFigures(trace);
  return figures.distance_m > kWorth && figures.made_good_m < kStraight * figures.distance_m;
}

std::vector<LegendEntry> drawMap(SvgText& svg, const Trace& trace, const Box& box) {
  return Map(svg, trace, box).draw();
}

}  // namespace glider::report::picture
