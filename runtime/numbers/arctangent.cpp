// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/function_constants.h"
#include "runtime/numbers/numbers.h"
#include "runtime/numbers/polynomial.h"
#include "runtime/numbers/trigonometry.h"

/// The angle of a point: folded into the first eighth of the circle, then
/// atan(b/a) = atan(t) + atan((b - t a) / (a + t b)) with t = k/8 nearest to b/a, so that the
/// second argument is at most 1/16 and its arctangent a short polynomial.
namespace glider::runtime {
namespace {

constexpr uint64_t kExponentBits = 0x7FF0000000000000U;
constexpr uint64_t kExponentOfOne = 0x3FF0000000000000U;
/// If the second coordinate is smaller by this many powers of two, the quotient is the angle.
constexpr uint64_t kFarApart = 60;

/// atan(small / big), 0 <= small <= big, 1 <= big < 2, small at least 2^-60.
Pair angleInEighth(double small, double big) {
  const int32_t k = static_cast<int32_t>(8.0 * (small / big) + 0.5);
  const double t = 0.125 * k;
  const Pair above = sumOf(negated(productOf(t, big)), small);
  const Pair below = sumOf(productOf(t, small), big);
  const Pair u = quotientOf(above, below);
  const double square = u.high * u.high;
  const double beyond = u.high * (square * polynomial(kArctangentRest, square));
  const double low = (beyond + u.low * (1.0 - square)) + kArctangentLow[k];
  const Pair sum = sumOf(kArctangentHigh[k], u.high);
  return sumOf(sum.high, sum.low + low);
}

/// The same for any two magnitudes: first divided by the power of two in `big`, bit by bit, so that
/// nothing overflows.
Pair angleOfMagnitudes(double small, double big) {
  const uint64_t scale = bitsOf(big) & kExponentBits;
  const uint64_t other = bitsOf(small) & kExponentBits;
  if (small == 0.0 || scale - other > (kFarApart << 52)) {
    return {small / big, 0.0};
  }
  const uint64_t shift = kExponentOfOne - scale;  // modulo 2^64
  return angleInEighth(doubleOf(bitsOf(small) + shift), doubleOf(bitsOf(big) + shift));
}

}  // namespace

Pair angleOf(double y, double x) {
  const double up = magnitude(y);
  const double along = magnitude(x);
  Pair angle;
  if (up <= along) {
    angle = angleOfMagnitudes(up, along);
  } else {
    angle = sumOf(negated(angleOfMagnitudes(along, up)), Pair{kHalfPi[0], kHalfPi[1]});
  }
  if (x < 0.0) {
    angle = sumOf(negated(angle), Pair{kPi[0], kPi[1]});
  }
  return y < 0.0 ? negated(angle) : angle;
}

}  // namespace glider::runtime

using namespace glider::runtime;

extern "C" double gliderAtan2(double y, double x) {
  const double up = gliderSettle(y);
  const double along = gliderSettle(x);
  if (!isFinite(up) || !isFinite(along) || (up == 0.0 && along == 0.0)) {
    return unknown();
  }
  return gliderSettle(angleOf(up, along).high);
}
