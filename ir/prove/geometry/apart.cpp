// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/geometry/apart.h"

#include "ir/prove/geometry/area_map.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <algorithm>

namespace glider::ir::prove {
namespace {

namespace geometry = boost::geometry;

using MapPoint = geometry::model::d2::point_xy<double>;
using Polygon = geometry::model::polygon<MapPoint>;

/// More than a metre of `distance`, which measures on a sphere, can be on the ellipsoid.
constexpr double kOfSphere = 1.01;

/// Everything in the area: of a disc its centre alone. A polygon whose edges cross each other is
/// the hull of its corners here, which holds it.
Polygon shapeOf(const AreaMap& map, const Geofence& area) {
  geometry::model::multi_point<MapPoint> corners;
  for (const Position& corner : area.corners) {
    const AreaMap::Point at = map.at(corner);
    corners.push_back({at.east, at.north});
  }
  Polygon shape;
  geometry::convex_hull(corners, shape);
  return shape;
}

/// A polygon as it is, if its edges do not cross; otherwise the hull.
Polygon areaOf(const AreaMap& map, const Geofence& area) {
  Polygon exact;
  for (const Position& corner : area.corners) {
    const AreaMap::Point at = map.at(corner);
    exact.outer().push_back({at.east, at.north});
  }
  geometry::correct(exact);
  return !area.isDisc() && geometry::is_valid(exact) ? exact : shapeOf(map, area);
}

double radiusOf(const Geofence& area) {
  return area.isDisc() ? kOfSphere * area.radius_m : 0;
}

/// Nothing is farther on the map than on the Earth, so the distance on the map is a lower bound.
double apart(const Geofence& one, const Geofence& other) {
  const AreaMap map(outlineOf(one), outlineOf(other));
  if (!map.holds(0)) {
    return 0;
  }
  const double between = geometry::distance(areaOf(map, one), areaOf(map, other));
  return std::max(between - radiusOf(one) - radiusOf(other), 0.0);
}

}  // namespace

double leastApart(const std::vector<Geofence>& one, const std::vector<Geofence>& other) {
  double most = 0;
  for (const Geofence& here : one) {
    for (const Geofence& there : other) {
      if (here.keep_in && there.keep_in) {
        most = std::max(most, apart(here, there));
      }
    }
  }
  return most;
}

}  // namespace glider::ir::prove
