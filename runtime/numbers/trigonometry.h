// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/numbers/pair.h"

namespace glider::runtime {

/// Both coordinates of a point on the unit circle.
struct SineCosine {
  Pair sine;
  Pair cosine;
};

/// Sine and cosine of an angle in degrees, |degrees| <= 720, zero or above 2^-200: exact at the
/// multiples of 90.
SineCosine sineCosineOfDegrees(const Pair& degrees);

/// The angle of the point (x, y) from the x axis towards the y axis, in rad, -pi < angle <= pi.
/// Both are finite and settled (ir/README.md), and not both zero.
Pair angleOf(double y, double x);

}  // namespace glider::runtime
