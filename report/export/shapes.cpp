// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/export/shapes.h"

#include "report/figures.h"
#include "support/trace/submersions.h"
#include "support/units/position_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace glider::report {
namespace {

using support::Trace;

constexpr double kNoTime = std::numeric_limits<double>::quiet_NaN();
constexpr double kHalfTurn = 180;
constexpr double kFullTurn = 360;
constexpr double kEarthRadius = 6371008.8;  // m, mean
constexpr int kRingPoints = 64;

/// Where a trace has positions.
struct PositionColumns {
  int latitude = -1, longitude = -1;
  [[nodiscard]] bool there() const { return latitude >= 0 && longitude >= 0; }
};

PositionColumns columnsOf(const Trace& trace, const char* latitude, const char* longitude) {
  return {trace.column(latitude), trace.column(longitude)};
}

std::optional<MapPoint> pointAt(const Trace& trace, size_t row, PositionColumns columns) {
  const MapPoint point{trace.at(row, columns.longitude), trace.at(row, columns.latitude),
                       trace.at(row, 0)};
  const bool known = std::isfinite(point.longitude_deg) && std::isfinite(point.latitude_deg);
  return known ? std::optional(point) : std::nullopt;
}

/// The point of the antimeridian on the way from `a` to `b`, on the side of `a`.
MapPoint onAntimeridian(const MapPoint& a, const MapPoint& b) {
  const double side = a.longitude_deg < 0 ? -kHalfTurn : kHalfTurn;
  const double far = b.longitude_deg + (side > 0 ? kFullTurn : -kFullTurn);
  const double part = (side - a.longitude_deg) / (far - a.longitude_deg);
  return {side, a.latitude_deg + (b.latitude_deg - a.latitude_deg) * part,
          a.time_s + (b.time_s - a.time_s) * part};
}

void extend(std::vector<std::vector<MapPoint>>& parts, const MapPoint& point) {
  if (parts.empty()) {
    parts.emplace_back();
  } else if (!parts.back().empty()) {
    const MapPoint last = parts.back().back();
    if (last.longitude_deg == point.longitude_deg && last.latitude_deg == point.latitude_deg) {
      return;
    }
    if (std::abs(last.longitude_deg - point.longitude_deg) > kHalfTurn) {
      const MapPoint cut = onAntimeridian(last, point);
      parts.back().push_back(cut);
      parts.push_back({{-cut.longitude_deg, cut.latitude_deg, cut.time_s}});
    }
  }
  parts.back().push_back(point);
}

void addLine(const Trace& trace, const char* name, PositionColumns columns, MapShapes& shapes) {
  MapLine line{name, {}};
  for (size_t row = 0; columns.there() && row < trace.rowCount(); ++row) {
    if (const auto point = pointAt(trace, row, columns)) {
      extend(line.parts, *point);
    }
  }
  std::erase_if(line.parts, [](const auto& part) { return part.size() < 2; });
  if (!line.parts.empty()) {
    shapes.lines.push_back(std::move(line));
  }
}

void addMark(const Trace& trace, size_t row, PositionColumns columns, const std::string& name,
             const char* kind, MapShapes& shapes) {
  if (const auto point = pointAt(trace, row, columns)) {
    shapes.marks.push_back({name, kind, *point});
  }
}

void addTrackMarks(const Trace& trace, PositionColumns columns, MapShapes& shapes) {
  if (trace.rowCount() == 0 || !columns.there()) {
    return;
  }
  addMark(trace, 0, columns, "start", "start", shapes);
  size_t number = 0;
  for (const support::Submersion& submersion : support::submersions(trace)) {
    if (submersion.end) {
      addMark(trace, *submersion.end, columns, fmt::format("surfacing {}", ++number), "surfacing",
              shapes);
    }
  }
  addMark(trace, trace.rowCount() - 1, columns, "end", "end", shapes);
}

/// The ring goes round by the east: it is counterclockwise.
MapRing ringOf(const support::WatchCircle& circle) {
  MapRing ring{fmt::format("{:.0f} m around {}", circle.radius_m,
                           support::positionText(circle.latitude_deg, circle.longitude_deg)),
               {}};
  const double degree = kHalfTurn / std::numbers::pi;
  const double radius_deg = circle.radius_m / kEarthRadius * degree;
  const double shrink = std::cos(circle.latitude_deg / degree);
  for (int i = 0; i <= kRingPoints; ++i) {
    const double angle = 2 * std::numbers::pi * (i % kRingPoints) / kRingPoints;
    ring.points.push_back({circle.longitude_deg + radius_deg / shrink * std::cos(angle),
                           circle.latitude_deg + radius_deg * std::sin(angle), kNoTime});
  }
  return ring;
}

}  // namespace

namespace {

double metresBetween(const MapPoint& a, const MapPoint& b) {
  const double degree_m = kEarthRadius * std::numbers::pi / kHalfTurn;
  const double east = std::remainder(a.longitude_deg - b.longitude_deg, kFullTurn) *
                      std::cos(a.latitude_deg * std::numbers::pi / kHalfTurn);
  return std::hypot(east, a.latitude_deg - b.latitude_deg) * degree_m;
}

/// What the vehicle was steered to and the mission has no name for.
void addSteered(const Trace& trace, MapShapes& shapes) {
  constexpr double kSame = 30;   // m: the same place
  constexpr size_t kMost = 100;  // more of them are a place that moves
  const PositionColumns columns = columnsOf(trace, "c_wpt_lat", "c_wpt_lon");
  size_t number = 0;
  for (size_t row = 0; columns.there() && row < trace.rowCount() && number < kMost; ++row) {
    auto point = pointAt(trace, row, columns);
    const bool known = point && std::ranges::any_of(shapes.marks, [&](const MapMark& mark) {
                         return mark.kind == "waypoint" && metresBetween(mark.at, *point) < kSame;
                       });
    if (point && !known) {
      point->time_s = kNoTime;
      shapes.marks.push_back({fmt::format("waypoint {}", ++number), "waypoint", *point});
    }
  }
}

}  // namespace

MapShapes shapesOf(const Trace& trace) {
  MapShapes shapes;
  const PositionColumns truth = columnsOf(trace, "true_lat", "true_lon");
  const PositionColumns reckoned = columnsOf(trace, "m_lat", "m_lon");
  addLine(trace, "true track", truth, shapes);
  addLine(trace, "dead-reckoned track", reckoned, shapes);
  addTrackMarks(trace, truth.there() ? truth : reckoned, shapes);
  for (const support::NamedPlace& place : trace.facts.places) {
    shapes.marks.push_back(
        {place.name, "waypoint", {place.longitude_deg, place.latitude_deg, kNoTime}});
  }
  addSteered(trace, shapes);
  for (const support::WatchCircle& circle : trace.facts.watch_circles) {
    shapes.rings.push_back(ringOf(circle));
  }
  return shapes;
}

}  // namespace glider::report
