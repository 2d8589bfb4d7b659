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

/// The place at the end of a great circle, as a point on the unit sphere: `along` towards the
/// meridian of its start, `across` to the east of it, `up` to the north.
struct Point {
  double along;
  double across;
  double up;
};

constexpr double kDegreesPerRadian = 180.0 / 3.141592653589793;

/// Todhunter, Spherical Trigonometry, art. 37 and 44, with the start on the meridian of longitude
/// 0. False if the distance is longer than half way around, or an argument is unknown.
bool offset(double latitude, double bearing, double distance, Point& end) {
  const double turned = 2.0 * distance / kEarthDiameter;
  if (!(magnitude(turned) <= 3.141592653589793)) {
    return false;
  }
  const SineCosine start = sineCosineOfDegrees({withoutDust(latitude), 0.0});
  const double east = gliderSin(bearing);
  const double north = gliderCos(bearing);
  const double far = gliderSin(turned);
  const double near = gliderCos(turned);
  end = {start.cosine.high * near - start.sine.high * far * north, far * east,
         start.sine.high * near + start.cosine.high * far * north};
  return isKnown(end.along) && isKnown(end.across);
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

extern "C" double gliderOffsetLatitude(double latitude, double longitude, double bearing,
                                       double distance) {
  Point end;
  if (!onEarth(latitude, longitude) || !offset(latitude, bearing, distance, end)) {
    return unknown();
  }
  const double degrees = angleOf(gliderSettle(end.up), root(gliderSettle(squared(end.along)) +
                                                            gliderSettle(squared(end.across))))
                             .high *
                         kDegreesPerRadian;
  return gliderSettle(degrees > 90.0 ? 90.0 : degrees < -90.0 ? -90.0 : degrees);
}

extern "C" double gliderOffsetLongitude(double latitude, double longitude, double bearing,
                                        double distance) {
  Point end;
  if (!onEarth(latitude, longitude) || !offset(latitude, bearing, distance, end)) {
    return unknown();
  }
  const double along = gliderSettle(end.along);
  const double across = gliderSettle(end.across);
  const double turned =
      along == 0.0 && across == 0.0 ? 0.0 : angleOf(across, along).high * kDegreesPerRadian;
  double degrees = longitude + turned;  // at most one and a half turns
  degrees = degrees > 180.0 ? degrees - 360.0 : degrees;
  degrees = degrees < -180.0 ? degrees + 360.0 : degrees;
  return gliderSettle(degrees > 180.0    ? degrees - 360.0
                      : degrees < -180.0 ? degrees + 360.0
                                         : degrees);
}
