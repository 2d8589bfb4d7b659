// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/front_seat/position.h"

#include "runtime/abi/glider_abi.h"
#include "runtime/numbers/numbers.h"

namespace glider::runtime {
namespace {

constexpr double kRadius_m = 6378137.0;            // WGS 84: half the greater axis
constexpr double kSquared = 6.69437999014131e-03;  // and its first eccentricity, squared

}  // namespace

Place displaced(const Place& from, double north_m, double east_m) {
  constexpr double kRough_m = 6371000.0;
  const double middle = from.latitude / kDegreesPerRadian + 0.5 * north_m / kRough_m;
  const double sine = gliderSin(middle);
  const double flat = 1.0 - kSquared * sine * sine;
  const double across_m = kRadius_m / __builtin_sqrt(flat);   // of the prime vertical
  const double along_m = across_m * (1.0 - kSquared) / flat;  // of the meridian
  return {from.latitude + north_m / along_m * kDegreesPerRadian,
          from.longitude + east_m / (across_m * gliderCos(middle)) * kDegreesPerRadian};
}

double ddmmOf(double degrees) {
  const double size = magnitude(degrees);
  const double minutes = restOf(size * 60.0, 60.0);
  const double whole = (size * 60.0 - minutes) / 60.0;
  const double ddmm = whole * 100.0 + minutes;
  return degrees < 0 ? negated(ddmm) : ddmm;
}

}  // namespace glider::runtime
