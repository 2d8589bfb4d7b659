// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/numbers.h"
#include "runtime/numbers/trigonometry.h"

/// Great circles on a sphere of the Earth's mean radius, (2 a + b) / 3 of WGS 84 (Moritz, Geodetic
/// Reference System 1980, Journal of Geodesy 74 (2000), 128-133, names it R1). Angles are reduced
/// in degrees, exactly: the poles and the antimeridian need no special cases.
namespace glider::runtime {
namespace {

constexpr double kEarthDiameter = 2 * 6371008.8;  // m
/// Degrees closer to zero than this are zero: a hundredth of a nanometre's millionth, and far from
/// where products underflow.
constexpr double kNoDegrees = 0x1p-60;

struct Place {
  double latitude;
  double longitude;
};

double withoutDust(double degrees) {
  return magnitude(degrees) < kNoDegrees ? 0.0 : degrees;
}

/// False for a position that is not on Earth or is unknown: a comparison with NaN is false.
bool onEarth(double latitude, double longitude) {
  return magnitude(latitude) <= 90.0 && magnitude(longitude) <= 360.0;
}

/// What both functions need for two places.
struct Halves {
  SineCosine latitudes;   ///< of half the difference
  SineCosine longitudes;  ///< of half the difference
  SineCosine middle;      ///< of the mean latitude
};

Halves halvesOf(const Place& from, const Place& to) {
  return {sineCosineOfDegrees(halved(differenceOf(to.latitude, from.latitude))),
          sineCosineOfDegrees(halved(differenceOf(to.longitude, from.longitude))),
          sineCosineOfDegrees(halved(sumOf(to.latitude, from.latitude)))};
}

double squared(double x) {
  return x * x;
}

double root(double x) {
  return __builtin_sqrt(x);
}

/// The haversine formula, with the haversine and its complement each computed as a sum of two
/// squares (Delambre's analogies; Todhunter, Spherical Trigonometry, 1886, art. 54), so that
/// neither near places nor antipodes lose digits.
double distance(const Place& from, const Place& to) {
  const Halves half = halvesOf(from, to);
  const double sine = squared(half.latitudes.sine.high * half.longitudes.cosine.high) +
                      squared(half.middle.cosine.high * half.longitudes.sine.high);
  const double cosine = squared(half.latitudes.cosine.high * half.longitudes.cosine.high) +
                        squared(half.middle.sine.high * half.longitudes.sine.high);
  return kEarthDiameter * angleOf(root(sine), root(cosine)).high;
}

/// The course at the start of the great circle (Todhunter, art. 44, multiplied out), its northern
/// part as sin(to - from) + 2 sin(from) cos(to) sin^2(half the longitude), which near places do not
/// cancel.
double bearing(const Place& from, const Place& to) {
  const Halves half = halvesOf(from, to);
  const SineCosine start = sineCosineOfDegrees({from.latitude, 0.0});
  const SineCosine end = sineCosineOfDegrees({to.latitude, 0.0});
  const double across = half.longitudes.sine.high;
  const double east = 2.0 * across * half.longitudes.cosine.high * end.cosine.high;
  const double north = 2.0 * half.latitudes.sine.high * half.latitudes.cosine.high +
                       2.0 * start.sine.high * end.cosine.high * squared(across);
  if (east == 0.0 && north == 0.0) {
    return unknown();
  }
  const double angle = angleOf(east, north).high;
  const double positive = angle < 0.0 ? angle + kTwoPi : angle;
  return positive < kTwoPi ? positive : 0.0;
}

}  // namespace
}  // namespace glider::runtime

using namespace glider::runtime;

extern "C" double gliderDistance(double latitude, double longitude, double to_latitude,
                                 double to_longitude) {
  if (!onEarth(latitude, longitude) || !onEarth(to_latitude, to_longitude)) {
    return unknown();
  }
  return gliderSettle(distance({withoutDust(latitude), withoutDust(longitude)},
                               {withoutDust(to_latitude), withoutDust(to_longitude)}));
}

extern "C" double gliderBearing(double latitude, double longitude, double to_latitude,
                                double to_longitude) {
  if (!onEarth(latitude, longitude) || !onEarth(to_latitude, to_longitude)) {
    return unknown();
  }
  return gliderSettle(bearing({withoutDust(latitude), withoutDust(longitude)},
                              {withoutDust(to_latitude), withoutDust(to_longitude)}));
}
