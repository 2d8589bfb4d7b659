// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/magnetism/declination.h"

#include "simulator/magnetism/magnetic_field.h"

#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kKmPerDeg = 111.7;      // the greatest length of a degree of latitude
constexpr double kLeastRadiusKm = 6350;  // of the Earth

/// The fastest change of the declination along the surface, rad/km: because the horizontal field
/// changes, with more effect where that field is weak, and because true north turns on the way
/// east.
double steepest(double latitude_deg, double horizontal_nT) {
  return Declination::kSteepest_nT_per_km / horizontal_nT +
         std::fabs(std::tan(latitude_deg * kRadiansPerDegree)) / kLeastRadiusKm;
}

}  // namespace

bool Declination::isNear(double latitude_deg, double longitude_deg) const {
  const double north_km = (latitude_deg - latitude_deg_) * kKmPerDeg;
  const double east_km = std::remainder(longitude_deg - longitude_deg_, 360) * kKmPerDeg;
  // A degree of longitude is shorter, so the distance is no greater.
  return std::hypot(north_km, east_km * std::cos(latitude_deg * kRadiansPerDegree)) <= radius_km_;
}

double Declination::at(double latitude_deg, double longitude_deg) {
  if (!isNear(latitude_deg, longitude_deg)) {
    // A bound computed here holds nearly as well at the rim of the area, less than a kilometre
    // away.
    constexpr double kShare = 0.9;
    const MagneticField field = magneticField(latitude_deg, longitude_deg, 0, year_);
    latitude_deg_ = latitude_deg;
    longitude_deg_ = longitude_deg;
    radius_km_ = kShare * kErrorRad / steepest(latitude_deg, field.horizontal_nT);
    declination_rad_ = field.declination_rad;
    ++computed_;
  }
  return declination_rad_;
}

}  // namespace glider::simulator
