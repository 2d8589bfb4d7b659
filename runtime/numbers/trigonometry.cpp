// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/numbers/trigonometry.h"

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/function_constants.h"
#include "runtime/numbers/numbers.h"
#include "runtime/numbers/polynomial.h"

/// Sine, cosine and tangent: an angle is split into a multiple of a quarter turn and a remainder of
/// at most an eighth, whose sine and cosine are polynomials. The remainder has twice a double's
/// precision, so that no digits are lost near zero.
namespace glider::runtime {
namespace {

/// The greatest angle that the functions take, 2^20 rad: up to it, the quarter turns in an angle
/// are a whole number of 20 bits, so that its products with the 33-bit pieces of pi/2 are exact.
constexpr double kGreatestAngle = 1048576.0;
/// Below this, 2^-28, an angle is its own sine and tangent, and its cosine is 1.
constexpr double kTinyAngle = 0x1p-28;

/// An angle as quarter turns and a rest of about pi/4 at most.
struct Reduced {
  int32_t quarters;
  Pair rest;
};

int32_t nearestInteger(double value) {
  return static_cast<int32_t>(value < 0 ? value - 0.5 : value + 0.5);
}

Reduced reduce(double angle) {
  const int32_t quarters = nearestInteger(angle * kTwoOverPi);
  const double n = quarters;
  // The first difference is exact: its terms are near each other or the rest is below 1.
  const double first = angle - n * kHalfPiPieces[0];
  const Pair second = differenceOf(first, n * kHalfPiPieces[1]);
  const Pair third = differenceOf(second.high, n * kHalfPiPieces[2]);
  const double low = (second.low + third.low) - n * kHalfPiPieces[3];
  return {quarters, sumOf(third.high, low)};
}

Pair sineOfRest(const Pair& rest) {
  const double x = rest.high;
  const double square = x * x;
  const double beyond = x * (square * polynomial(kSineRest, square));
  return sumOf(x, beyond + rest.low * (1.0 - 0.5 * square));
}

Pair cosineOfRest(const Pair& rest) {
  const double x = rest.high;
  const Pair square = productOf(x, x);
  const Pair parabola = sumOf(1.0, -0.5 * square.high);
  const double beyond = square.high * (square.high * polynomial(kCosineRest, square.high));
  const double low = (beyond - 0.5 * square.low) - x * rest.low;
  return sumOf(parabola.high, parabola.low + low);
}

SineCosine turn(const Reduced& angle) {
  const Pair sine = sineOfRest(angle.rest);
  const Pair cosine = cosineOfRest(angle.rest);
  switch (static_cast<uint32_t>(angle.quarters) & 3U) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, negated(sine)};
    case 2:
      return {negated(sine), negated(cosine)};
    default:
      return {negated(cosine), sine};
  }
}

/// False for an unknown angle: a comparison with NaN is false.
bool inRange(double angle) {
  return magnitude(angle) <= kGreatestAngle;
}

}  // namespace

SineCosine sineCosineOfDegrees(const Pair& degrees) {
  const int32_t quarters = nearestInteger(degrees.high / 90.0);
  const Pair rest = sumOf(degrees.high - 90.0 * quarters, degrees.low);  // both steps exact
  return turn({quarters, productOf(rest, {kDegree[0], kDegree[1]})});
}

}  // namespace glider::runtime

using namespace glider::runtime;

extern "C" double gliderSin(double angle) {
  if (!inRange(angle)) {
    return unknown();
  }
  return gliderSettle(magnitude(angle) < kTinyAngle ? angle : turn(reduce(angle)).sine.high);
}

extern "C" double gliderCos(double angle) {
  if (!inRange(angle)) {
    return unknown();
  }
  return gliderSettle(magnitude(angle) < kTinyAngle ? 1.0 : turn(reduce(angle)).cosine.high);
}

extern "C" double gliderTan(double angle) {
  if (!inRange(angle)) {
    return unknown();
  }
  if (magnitude(angle) < kTinyAngle) {
    return gliderSettle(angle);
  }
  const SineCosine point = turn(reduce(angle));
  return gliderSettle(quotientOf(point.sine, point.cosine).high);
}
