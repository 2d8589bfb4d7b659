// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/magnetism/magnetic_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

constexpr int kDegree = 12;
constexpr double kEpoch = 2025;
constexpr double kModelRadius = 6371.2;                      // km
constexpr double kEquator = 6378.137, kPole = 6356.7523142;  // km, half axes of WGS 84
constexpr double kRadPerDeg = std::numbers::pi / 180;

struct Term {
  int n, m;
  double g, h, g_change, h_change;
};
constexpr Term kTerms[] = {
#define TERM(n, m, g, h, g_change, h_change) {n, m, g, h, g_change, h_change},
#include "simulator/magnetism/wmm2025.def"
#undef TERM
};

/// Schmidt semi-normalized associated Legendre functions of cos(colatitude), and their derivatives
/// by the colatitude.
struct Legendre {
  /// Of degree n and order m; those with m > n are not used.
  double p[kDegree + 1][kDegree + 1] = {};
  double slope[kDegree + 1][kDegree + 1] = {};
  Legendre(double cosine, double sine) {
    p[0][0] = 1;
    for (int n = 1; n <= kDegree; ++n) {
      const double k = n == 1 ? 1 : std::sqrt((2.0 * n - 1) / (2.0 * n));
      p[n][n] = k * sine * p[n - 1][n - 1];
      slope[n][n] = k * (sine * slope[n - 1][n - 1] + cosine * p[n - 1][n - 1]);
      for (int m = 0; m < n; ++m) {
        const double two_less = std::sqrt((n - 1.0) * (n - 1.0) - m * m);
        const double norm = std::sqrt(static_cast<double>(n * n - m * m));
        const double p2 = m <= n - 2 ? p[n - 2][m] : 0;
        const double slope2 = m <= n - 2 ? slope[n - 2][m] : 0;
        p[n][m] = ((2.0 * n - 1) * cosine * p[n - 1][m] - two_less * p2) / norm;
        slope[n][m] =
            ((2.0 * n - 1) * (cosine * slope[n - 1][m] - sine * p[n - 1][m]) - two_less * slope2) /
            norm;
      }
    }
  }
};

/// A geodetic position in geocentric coordinates.
struct Geocentric {
  double radius_km, cosine, sine;  ///< of the colatitude
  double tilt_rad;                 ///< geocentric less geodetic latitude
  Geocentric(double latitude_deg, double height_km) {
    const double latitude = latitude_deg * kRadPerDeg;
    const double a2 = kEquator * kEquator, b2 = kPole * kPole;
    const double normal =
        a2 / std::sqrt(a2 * std::pow(std::cos(latitude), 2) + b2 * std::pow(std::sin(latitude), 2));
    const double out = (normal + height_km) * std::cos(latitude);
    const double up = (normal * b2 / a2 + height_km) * std::sin(latitude);
    radius_km = std::hypot(out, up);
    cosine = up / radius_km;
    // Never 0: at a pole, east is defined by the given longitude.
    sine = std::max(out / radius_km, 1e-10);
    tilt_rad = std::atan2(up, out) - latitude;
  }
};

}  // namespace

MagneticField magneticField(double latitude_deg, double longitude_deg, double height_km,
                            double year) {
  const Geocentric place(latitude_deg, height_km);
  const Legendre legendre(place.cosine, place.sine);
  const double since = year - kEpoch;
  const double longitude = longitude_deg * kRadPerDeg;
  double north = 0, east = 0, down = 0;
  for (const Term& t : kTerms) {
    const double g = t.g + since * t.g_change, h = t.h + since * t.h_change;
    const double cosine = std::cos(t.m * longitude), sine = std::sin(t.m * longitude);
    const double power = std::pow(kModelRadius / place.radius_km, t.n + 2);
    const double along = power * (g * cosine + h * sine);
    north += along * legendre.slope[t.n][t.m];
    down -= along * (t.n + 1) * legendre.p[t.n][t.m];
    east += power * t.m * (g * sine - h * cosine) * legendre.p[t.n][t.m] / place.sine;
  }
  const double level = north * std::cos(place.tilt_rad) - down * std::sin(place.tilt_rad);
  const double plumb = north * std::sin(place.tilt_rad) + down * std::cos(place.tilt_rad);
  const double horizontal = std::hypot(level, east);
  return {horizontal, std::atan2(plumb, horizontal), std::atan2(east, level)};
}

}  // namespace glider::simulator
