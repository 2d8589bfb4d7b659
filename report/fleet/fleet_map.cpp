// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/fleet/fleet_report.h"
#include "report/picture/colours.h"
#include "report/picture/flight_view.h"
#include "report/picture/page.h"

#include <algorithm>
#include <cmath>

namespace glider::report {

using namespace picture;

namespace {

constexpr double kMapWide = 620, kMapLeft = 84, kMapTop = 14, kMapRight = 16, kMapBottom = 52;

/// The true track of a vehicle, m from the fleet's origin.
Line trackOf(const FleetVehicleReport& vehicle) {
  Line line;
  for (size_t i = 0; i < vehicle.east_m.size(); ++i) {
    if (std::isfinite(vehicle.east_m[i]) && std::isfinite(vehicle.north_m[i])) {
      line.push_back({vehicle.east_m[i], vehicle.north_m[i]});
    }
  }
  return line;
}

/// A square of the sea that holds all tracks.
struct View {
  Dot middle;
  double metres = 0;
};

View viewOf(const std::vector<Line>& tracks) {
  std::vector<double> east, north;
  for (const Line& track : tracks) {
    for (const Dot& dot : track) {
      east.push_back(dot.x);
      north.push_back(dot.y);
    }
  }
  constexpr double kMargin = 1.16, kLeast_m = 20;
  const Extent across = extentOf(east), up = extentOf(north);
  const double size = std::max({across.greatest - across.least, up.greatest - up.least, kLeast_m});
  return {{(across.least + across.greatest) / 2, (up.least + up.greatest) / 2}, kMargin * size};
}

class FleetMap {
 public:
  FleetMap(SvgText& svg, const View& view, const Box& box) : svg_(svg), box_(box) {
    constexpr double kKilometre = 1000, kLargeMap_m = 5000;
    const bool km = view.metres > kLargeMap_m;
    unit_ = km ? kKilometre : 1;
    const double half = view.metres / 2;
    across_ =
        Axis((view.middle.x - half) / unit_, (view.middle.x + half) / unit_, box.left, box.right);
    up_ = Axis((view.middle.y - half) / unit_, (view.middle.y + half) / unit_, box.bottom, box.top);
    constexpr int kTicks = 6;
    const double step = niceStep(view.metres / unit_, kTicks);
    addAcross(svg_, box_, across_, step, km ? "east (km)" : "east (m)");
    addUp(svg_, box_, up_, step, km ? "north (km)" : "north (m)");
  }

  void draw(const Line& track, const std::string& colour, const std::string& name) {
    Line line;
    for (const Dot& dot : track) {
      line.push_back({across_.at(dot.x / unit_), up_.at(dot.y / unit_)});
    }
    if (line.empty()) {
      return;
    }
    addPaths(svg_, "track", {{colour, {simplified(line, kUnseen)}}});
    const Dot first = line.front(), last = line.back();
    svg_.add("<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"6\"/>\n", px(first.x), px(first.y));
    constexpr double kEnd = 9;
    svg_.add("<rect class=\"mark\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
             px(last.x - kEnd / 2), px(last.y - kEnd / 2), px(kEnd), px(kEnd));
    const bool to_left = last.x > (box_.left + box_.right) / 2;
    constexpr double kAside = 9, kBelow = 4;
    names_.push_back({{last.x + (to_left ? -kAside : kAside), last.y + kBelow}, to_left, name});
  }

  /// The names are above all lines; one that would cover another one moves down.
  void finish() {
    addFrame(svg_, box_);
    std::ranges::sort(names_, {}, [](const Name& name) { return name.at.y; });
    std::vector<Box> taken;
    for (const Name& name : names_) {
      Box place = boxOf(name);
      const auto covers = [&](const Box& other) {
        return place.left < other.right && other.left < place.right && place.top < other.bottom &&
               other.top < place.bottom;
      };
      // Each move is downwards, so it ends.
      for (auto other = std::ranges::find_if(taken, covers); other != taken.end();
           other = std::ranges::find_if(taken, covers)) {
        place.bottom += other->bottom - place.top;
        place.top = other->bottom;
      }
      taken.push_back(place);
      addText(svg_, {name.at.x, place.bottom}, name.to_left ? "end" : "start", "label halo",
              name.text);
    }
  }

 private:
  struct Name {
    Dot at;
    bool to_left;
    std::string text;
  };

  /// What the name covers; its reference point is at the lower edge.
  static Box boxOf(const Name& name) {
    const double wide = textWidth(name.text, kLabelFont);
    const double left = name.to_left ? name.at.x - wide : name.at.x;
    return {left, name.at.y - kLabelFont, left + wide, name.at.y};
  }

  SvgText& svg_;
  Box box_;
  double unit_ = 1;
  Axis across_{0, 1, 0, 1}, up_{0, 1, 0, 1};
  std::vector<Name> names_;
};

}  // namespace

std::string vehicleColour(const FleetReport& fleet, size_t vehicle) {
  constexpr size_t kOfStates = 6;  // the seventh is too light for a thin line
  return fleet.vehicles.size() <= kOfStates ? std::string(stateColour(static_cast<double>(vehicle)))
                                            : scaleColour(vehicle, fleet.vehicles.size());
}

std::string drawFleetMap(const FleetReport& fleet) {
  std::vector<Line> tracks;
  for (const FleetVehicleReport& vehicle : fleet.vehicles) {
    tracks.push_back(trackOf(vehicle));
  }
  SvgText svg;
  beginPage(svg, kMapLeft + kMapWide + kMapRight, kMapTop + kMapWide + kMapBottom,
            "the tracks of the fleet " + fleet.name);
  FleetMap map(svg, viewOf(tracks), {kMapLeft, kMapTop, kMapLeft + kMapWide, kMapTop + kMapWide});
  for (size_t i = 0; i < tracks.size(); ++i) {
    map.draw(tracks[i], vehicleColour(fleet, i), fleet.vehicles[i].name);
  }
  map.finish();
  svg.add("</svg>\n");
  return svg.take();
}

}  // namespace glider::report
