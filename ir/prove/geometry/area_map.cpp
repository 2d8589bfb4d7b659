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
/// A degree on the sphere of `distance`, rounded up, m.
constexpr double kLongestDegree = 6371009 * std::numbers::pi / 180;
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
  /// The least magnitude of a number between them.
  [[nodiscard]] double nearestToZero() const { return std::max({least_, -most_, 0.0}); }

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

std::vector<MapPoint> onMap(const AreaMap& map, const std::vector<Position>& places) {
  std::vector<MapPoint> points;
  for (const Position& place : places) {
    const AreaMap::Point p = map.at(place);
    points.emplace_back(p.east, p.north);
  }
  return points;
}

bool isInHull(const MapPoint& point, const Line& hull) {
  Polygon within;
  within.outer().assign(hull.begin(), hull.end());
  geometry::correct(within);
  return hull.size() > 3 && geometry::within(point, within);
}

/// No place of the map is closer to the centre than on the map.
Clearance outOfDisc(const AreaMap& map, const Geofence& disc, const Line& hull) {
  const MapPoint centre = onMap(map, disc.corners).front();
  const double distance = geometry::distance(hull, centre) - disc.radius_m;
  return {distance > 0 && !isInHull(centre, hull), distance};
}

}  // namespace

std::vector<Position> outlineOf(const Geofence& fence) {
  if (!fence.isDisc()) {
    return fence.corners;
  }
  const Position& centre = fence.corners.front();
  const double high = fence.radius_m / kShortestDegree;
  // On a way of that length a degree of longitude is nowhere narrower than at the disc's latitude
  // farthest from the equator.
  const double outermost = std::min(std::fabs(centre.latitude) + high, 89.0);
  const double wide = high / std::cos(outermost * std::numbers::pi / 180);
  const double south = centre.latitude - high, north = centre.latitude + high;
  const double west = centre.longitude - wide, east = centre.longitude + wide;
  return {{south, west}, {south, east}, {north, east}, {north, west}};
}

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
  nearest_ = north.nearestToZero();
  width_ = east.size();
  east_scale_ = kShortestDegree * std::cos(outermost());
  length_ = kMetresPerDegree *
            std::hypot(north.size(), east.size() * std::cos(nearest * std::numbers::pi / 180));
}

double AreaMap::outermost() const {
  return std::min(farthest_ + kBeyond, 89.0) * std::numbers::pi / 180;
}

double AreaMap::stretch(double beyond) const {
  const double innermost = std::max(nearest_ - beyond / kShortestDegree, 0.0);
  return kLongestDegree / kShortestDegree * std::cos(innermost * std::numbers::pi / 180) /
         std::cos(outermost());
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
  const Line hull = lineRound(onMap(*this, waypoints));
  if (fence.isDisc()) {
    return fence.keep_in ? inDisc(fence, waypoints) : outOfDisc(*this, fence, hull);
  }
  const std::vector<MapPoint> corners = onMap(*this, fence.corners);
  const double distance = geometry::distance(hull, edgesOf(corners));
  // If no edges cross, an area whose edge lies in the hull contains no part of the hull's border.
  const bool around = isInHull(corners.front(), hull);
  const bool right_side = distance > 0 && !around && inside(corners, hull.front()) == fence.keep_in;
  return {right_side, distance};
}

/// The way from the centre that is straight on the map is at least as long as the shortest. Its
/// length, were it all at the latitude nearest to the equator, is a norm, so in the hull a corner
/// has the greatest.
Clearance AreaMap::inDisc(const Geofence& disc, const std::vector<Position>& waypoints) const {
  const Position& centre = disc.corners.front();
  const double narrow = std::cos(nearest_ * std::numbers::pi / 180);
  double farthest = 0;
  for (const Position& place : waypoints) {
    const double east = std::remainder(place.longitude - centre.longitude, 360);
    const double north = place.latitude - centre.latitude;
    farthest = std::max(farthest, kLongestDegree * std::hypot(north, narrow * east));
  }
  const double left = disc.radius_m - farthest;  // a margin that fits is no longer
  return {left > 0, left / stretch(std::max(left, 0.0))};
}

}  // namespace glider::ir::prove
