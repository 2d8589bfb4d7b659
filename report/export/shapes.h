// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <string>
#include <vector>

namespace glider::report {

/// A position on Earth, degrees, and when the vehicle was there, vehicle time in s.
struct MapPoint {
  double longitude_deg = 0, latitude_deg = 0;
  double time_s = 0;
};

/// A line on the map. Where it crosses the antimeridian it is cut.
struct MapLine {
  std::string name;
  std::vector<std::vector<MapPoint>> parts;  ///< of two points at least
};

struct MapMark {
  std::string name;
  std::string kind;  ///< "start", "end", "surfacing" or "waypoint"
  MapPoint at;       ///< a waypoint has no time: NaN
};

/// A closed ring, counterclockwise, its first point repeated at its end.
struct MapRing {
  std::string name;
  std::vector<MapPoint> points;
};

/// What of a flight is drawn on a map by another program.
struct MapShapes {
  std::vector<MapLine> lines;  ///< the true track, then the dead-reckoned one
  std::vector<MapMark> marks;
  std::vector<MapRing> rings;  ///< each watch circle
};

MapShapes shapesOf(const support::Trace& trace);

}  // namespace glider::report
