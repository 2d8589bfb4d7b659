// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/hookbeh/position.h"

#include "hooks/protocol/numbers.h"

#include <stdint.h>

namespace glider::hooks {
namespace {

constexpr double kMetresPerDegree = 111120;
constexpr double kRadPerDegree = 0.017453292519943295;

double degrees(double ddmm) {
  const auto whole = static_cast<int32_t>(ddmm / 100);
  return whole + (ddmm - 100.0 * whole) / 60;
}

/// The cosine up to a right angle, within 0.001; there is no math library on board.
double cosine(double rad) {
  const double square = rad * rad;
  return atLeast(1 - square / 2 + square * square / 24 - square * square * square / 720, 0);
}

}  // namespace

bool isKnown(const Position& at) {
  return magnitude(at.latitude_ddmm) <= 9000 && magnitude(at.longitude_ddmm) <= 18000;
}

double distanceBetween(const Position& a, const Position& b) {
  if (!isKnown(a) || !isKnown(b)) {
    return 0;
  }
  const double latitude = degrees(a.latitude_ddmm);
  const double north = magnitude(latitude - degrees(b.latitude_ddmm));
  const double east = magnitude(degrees(a.longitude_ddmm) - degrees(b.longitude_ddmm));
  const double shorter = atMost(360 - east, east);  // across the date line
  return kMetresPerDegree * atLeast(shorter * cosine(latitude * kRadPerDegree), north);
}

}  // namespace glider::hooks
