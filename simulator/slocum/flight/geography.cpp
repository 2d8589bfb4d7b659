// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/geography.h"

#include "simulator/geography/ddmm.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/UTMUPS.hpp>

#include <cmath>

namespace glider::simulator {
namespace {

GeoPosition degrees(const WaypointPosition& position) {
  return {fromDdmm(position.latitude_ddmm), fromDdmm(position.longitude_ddmm)};
}

WaypointPosition vehicles(GeoPosition position) {
  return {toDdmm(position.latitude_deg), toDdmm(position.longitude_deg)};
}

}  // namespace

WaypointPosition Geography::position(WaypointUnits units, double x, double y) const {
  switch (units) {
    case WaypointUnits::LocalMetres: {
      const Planar from_start = fromLocal(x, y);
      return vehicles(LocalFrame(start_.latitude_deg, start_.longitude_deg)
                          .position(from_start.east, from_start.north));
    }
    case WaypointUnits::Utm: {
      // In the zone of the mission's start.
      int zone = 0;
      bool north = true;
      double start_x = 0, start_y = 0;
      GeographicLib::UTMUPS::Forward(start_.latitude_deg, start_.longitude_deg, zone, north,
                                     start_x, start_y);
      GeoPosition found;
      GeographicLib::UTMUPS::Reverse(zone, north, x, y, found.latitude_deg, found.longitude_deg);
      return vehicles(found);
    }
    case WaypointUnits::LatLon:
      break;
  }
  return {y, x};
}

Planar Geography::fromLocal(double x, double y) const {
  return {x * std::cos(variation_) - y * std::sin(variation_),
          x * std::sin(variation_) + y * std::cos(variation_)};
}

Planar Geography::toLocal(Planar towards) const {
  return {towards.east * std::cos(variation_) + towards.north * std::sin(variation_),
          towards.north * std::cos(variation_) - towards.east * std::sin(variation_)};
}

double Geography::distance(const WaypointPosition& a, const WaypointPosition& b) {
  const GeoPosition from = degrees(a), to = degrees(b);
  double metres = 0;
  GeographicLib::Geodesic::WGS84().Inverse(from.latitude_deg, from.longitude_deg, to.latitude_deg,
                                           to.longitude_deg, metres);
  return metres;
}

}  // namespace glider::simulator
