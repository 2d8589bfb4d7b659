// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir::prove {

/// The position of an area relative to the hull of some waypoints.
struct Clearance {
  bool right_side = false;  ///< the hull is all inside the area, or all outside, as required
  double distance_m = 0;    ///< from the hull to the area's edge; never more than the true distance
};

/// Places round a geofence: the corners of a polygon, or of a box in latitude and longitude that
/// contains the disc.
std::vector<Position> outlineOf(const Geofence& fence);

/// A map of a small region whose straight lines are straight in latitude and longitude, and in
/// which distances are never longer than on the Earth. A degree of longitude is as long as at the
/// map's latitude farthest from the equator; a degree of latitude is as long as at the equator of
/// the WGS 84 ellipsoid, where it is shortest.
class AreaMap {
 public:
  /// A map of the region of all these; at least one place.
  AreaMap(const std::vector<Position>& corners, const std::vector<Position>& waypoints);
  /// A map of the region of an area and some places.
  AreaMap(const Geofence& fence, const std::vector<Position>& waypoints)
      : AreaMap(outlineOf(fence), waypoints) {}

  /// Whether the map is valid for all places within `metres` of those: it must not be too near a
  /// pole, or too wide.
  [[nodiscard]] bool holds(double metres) const;

  [[nodiscard]] Clearance clearance(const Geofence& fence,
                                    const std::vector<Position>& waypoints) const;
  /// An upper bound, m, of the distance between the map's straight line and the shortest way
  /// between two of the places, or from one to a place within `beyond` metres of another: the
  /// sagitta of a great circle against its parallel.
  [[nodiscard]] double bend_m(double beyond) const;
  /// How many metres of the Earth, at most, a metre of the map is within `beyond` metres of the
  /// places: so much farther may one place be from another as `distance` measures.
  [[nodiscard]] double stretch(double beyond) const;

  struct Point {
    double east, north;  ///< m
  };
  [[nodiscard]] Point at(const Position& place) const;

 private:
  [[nodiscard]] Clearance inDisc(const Geofence& disc,
                                 const std::vector<Position>& waypoints) const;
  /// The map's latitude farthest from the equator, rad.
  [[nodiscard]] double outermost() const;

  Position origin_;
  double farthest_ = 0;    ///< from the equator, degrees
  double nearest_ = 0;     ///< to the equator, degrees; 0 if places lie on both sides of it
  double width_ = 0;       ///< degrees of longitude
  double east_scale_ = 0;  ///< m in a degree
  double length_ = 0;      ///< of the longest way between two of the places, m
};

}  // namespace glider::ir::prove
