// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::runtime {

inline constexpr double kDegreesPerRadian = 180.0 / 3.141592653589793;

/// A place on WGS 84, degrees; NaN: unknown.
struct Place {
  double latitude = __builtin_nan("");
  double longitude = __builtin_nan("");
};

/// The place that is `north` and `east` of another, m: along its meridian and its parallel, by the
/// radii of curvature of the ellipsoid half way (Torge, Geodesy, 4.1.3). Within 0.3 m to 20 km,
/// below 70 degrees.
Place displaced(const Place& from, double north_m, double east_m);

/// As the vehicle of the language has positions: ddmm.mmmm with the sign of the degrees.
double ddmmOf(double degrees);

}  // namespace glider::runtime
