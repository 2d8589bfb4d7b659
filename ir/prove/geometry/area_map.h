// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <vector>

namespace glider::ir::prove {

/// How an area and the hull of some waypoints lie to each other.
struct Clearance {
  bool right_side = false;  ///< the hull is all inside the area, or all outside, as the fence wants
  double distance_m = 0;    ///< from the hull to the area's edge, never more than it is
};

/// A map of a neighbourhood whose straight lines are straight in latitude and longitude, and in
/// which distances are never longer than on the Earth: a degree of longitude is taken as long as on
/// the latitude of the map that is farthest from the equator, one of latitude as long as it is at
/// the equator of the WGS 84 ellipsoid, where it is shortest.
class AreaMap {
 public:
  /// Of the neighbourhood of all these; one place at least.
  AreaMap(const std::vector<Position>& corners, const std::vector<Position>& waypoints);

  /// Whether it is one of all places within `metres` of those: not so near a pole, nor so wide,
  /// that it would be none.
  [[nodiscard]] bool holds(double metres) const;

  [[nodiscard]] Clearance clearance(const Geofence& fence,
                                    const std::vector<Position>& waypoints) const;
  /// How far the shortest way between two of the places, or from one to a place within `beyond`
  /// metres of another, is off the map's straight line, m, at most: the sagitta of a great circle
  /// against its parallel.
  [[nodiscard]] double bend_m(double beyond) const;

 private:
  struct Point {
    double east, north;  ///< m
  };
  [[nodiscard]] Point at(const Position& place) const;
  /// The map's latitude farthest from the equator, rad.
  [[nodiscard]] double outermost() const;

  Position origin_;
  double farthest_ = 0;    ///< from the equator, degrees
  double width_ = 0;       ///< degrees of longitude
  double east_scale_ = 0;  ///< m in a degree
  double length_ = 0;      ///< of the longest way between two of the places, m
};

}  // namespace glider::ir::prove
