// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/geometry/area_map.h"

#include "ir/prove/geometry/sphere.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace glider::ir::prove {
namespace {

namespace geometry = boost::geometry;

using MapPoint = geometry::model::d2::point_xy<double>;
using Line = geometry::model::linestring<MapPoint>;
using Polygon = geometry::model::polygon<MapPoint>;

/// The shortest degree of latitude on WGS 84, m: 110,574.3 at the equator. A degree of longitude is
/// never shorter than the cosine of its latitude times this.
constexpr double kShortestDegree = 110574;
/// How far a vehicle may get beyond the named places, degrees of latitude.
constexpr double kBeyond = 3;
/// At higher latitudes the map's degrees of longitude would differ too much, degrees.
constexpr double kNearPole = 85;
/// If the places span more, the direction round the Earth is ambiguous, degrees.
constexpr double kWidest = 90;

/// From the least of some numbers to the greatest.
class Extent {
 public:
  void add(double x) {
    least_ = std::min(least_, x);
    most_ = std::max(most_, x);
  }
  [[nodiscard]] double size() const { return most_ - least_; }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = -std::numeric_limits<double>::infinity();
};

/// The hull as a closed line: for one or two waypoints Boost's polygon would be empty.
Line lineRound(const std::vector<MapPoint>& waypoints) {
  geometry::model::multi_point<MapPoint> points(waypoints.begin(), waypoints.end());
  Polygon hull;
  geometry::convex_hull(points, hull);
  Line line(hull.outer().begin(), hull.outer().end());
  line.push_back(line.empty() ? waypoints.front() : line.front());
  if (line.size() < 2) {
    line.push_back(waypoints.front());
  }
  return line;
}

/// Crossing number of a ray to the east, as the language's `inside` does; edges may cross each
/// other.
bool inside(const std::vector<MapPoint>& corners, const MapPoint& p) {
  bool odd = false;
  for (size_t i = 0; i < corners.size(); ++i) {
    const MapPoint& a = corners[i];
    const MapPoint& b = corners[(i + 1) % corners.size()];
    if ((a.y() <= p.y()) != (b.y() <= p.y())) {
      const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      odd ^= x > p.x();
    }
  }
  return odd;
}

Line edgesOf(const std::vector<MapPoint>& corners) {
  Line line(corners.begin(), corners.end());
  line.push_back(corners.front());
  return line;
}

}  // namespace

AreaMap::AreaMap(const std::vector<Position>& corners, const std::vector<Position>& waypoints)
    : origin_(corners.front()) {
  std::vector<Position> all = corners;
  all.insert(all.end(), waypoints.begin(), waypoints.end());
  double nearest = 90;
  Extent north;
  Extent east;
  for (const Position& place : all) {
    farthest_ = std::max(farthest_, std::fabs(place.latitude));
    nearest = std::min(nearest, std::fabs(place.latitude));
    north.add(place.latitude);
    east.add(std::remainder(place.longitude - origin_.longitude, 360));
  }
  width_ = east.size();
  east_scale_ = kShortestDegree * std::cos(outermost());
  length_ = kMetresPerDegree *
            std::hypot(north.size(), east.size() * std::cos(nearest * std::numbers::pi / 180));
}

double AreaMap::outermost() const {
  return std::min(farthest_ + kBeyond, 89.0) * std::numbers::pi / 180;
}

double AreaMap::bend_m(double beyond) const {
  const double length = length_ + beyond;
  return length * length * std::tan(outermost()) / (8 * kEarthRadius);
}

AreaMap::Point AreaMap::at(const Position& place) const {
  return {std::remainder(place.longitude - origin_.longitude, 360) * east_scale_,
          (place.latitude - origin_.latitude) * kShortestDegree};
}

bool AreaMap::holds(double metres) const {
  return farthest_ <= kNearPole && width_ <= kWidest && metres <= kBeyond * kShortestDegree;
}

Clearance AreaMap::clearance(const Geofence& fence, const std::vector<Position>& waypoints) const {
  const auto onMap = [&](const std::vector<Position>& places) {
    std::vector<MapPoint> points;
    for (const Position& place : places) {
      const Point p = at(place);
      points.emplace_back(p.east, p.north);
    }
    return points;
  };
  const std::vector<MapPoint> corners = onMap(fence.corners);
  const Line hull = lineRound(onMap(waypoints));
  const Line edges = edgesOf(corners);
  const double distance = geometry::distance(hull, edges);
  Polygon within;
  within.outer().assign(hull.begin(), hull.end());
  geometry::correct(within);
  // If no edges cross, an area whose edge lies in the hull contains no part of the hull's border.
  const bool around = hull.size() > 3 && geometry::within(corners.front(), within);
  const bool right_side = distance > 0 && !around && inside(corners, hull.front()) == fence.keep_in;
  return {right_side, distance};
}

}  // namespace glider::ir::prove
